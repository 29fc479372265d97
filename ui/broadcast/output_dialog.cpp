// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/broadcast/output_dialog.h"

#include "ui/document/document.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <initializer_list>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kHighestPort = 65535;
constexpr int kFieldWidth = 260;
// Proposals for ports that are off. Chosen: nothing usual has them.
constexpr int kTcpPort = 9001;
constexpr int kWebPort = 9002;
const char* const kThisComputer = "127.0.0.1";
const char* const kAllComputers = "0.0.0.0";

QSpinBox* makePort(const char* name, int port, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(QLatin1String(name));
  box->setRange(1, kHighestPort);
  box->setValue(port);
  box->setGroupSeparatorShown(false);
  return box;
}

std::optional<std::uint16_t> portOf(const QCheckBox& on, const QSpinBox& port) {
  return on.isChecked() ? std::optional(static_cast<std::uint16_t>(port.value())) : std::nullopt;
}

void showPort(QCheckBox& on, QSpinBox& box, const std::optional<std::uint16_t>& port) {
  on.setChecked(port.has_value());
  box.setEnabled(port.has_value());
  if (port.value_or(0) > 0) {
    box.setValue(*port);
  }
}

} // namespace

OutputDialog::OutputDialog(Document& document, QWidget* parent)
    : QDialog(parent), document_(document), intro_(new QLabel(this)), form_(new QFormLayout),
      tcp_(new QCheckBox(this)), tcpPort_(makePort("outputTcpPort", kTcpPort, this)),
      web_(new QCheckBox(this)), webPort_(makePort("outputWebPort", kWebPort, this)),
      page_(new QLabel(this)), osc_(new QLineEdit(this)), tuio_(new QLineEdit(this)),
      csv_(new QLineEdit(this)), listen_(makeChoiceField("outputListen", this)),
      axes_(makeChoiceField("outputAxes", this)), unit_(makeChoiceField("outputUnit", this)),
      rate_(new QSpinBox(this)), token_(new QLineEdit(this)), problem_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setObjectName(QStringLiteral("outputDialog"));
  arrange();
  for (const auto& [on, port] : {std::pair(tcp_, tcpPort_), std::pair(web_, webPort_)}) {
    connect(on, &QCheckBox::toggled, port, &QWidget::setEnabled);
  }
  const auto showPage = [this] {
    page_->setVisible(web_->isChecked());
    page_->setText(QStringLiteral("<a href=\"http://127.0.0.1:%1/\">http://127.0.0.1:%1/</a>")
                       .arg(webPort_->value()));
  };
  connect(web_, &QCheckBox::toggled, this, showPage);
  connect(webPort_, &QSpinBox::valueChanged, this, showPage);
  connect(buttons_, &QDialogButtonBox::accepted, this, &OutputDialog::apply);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&document_, &Document::projectReplaced, this, &QDialog::reject);
  onRetranslate(this, [this] { retranslateUi(); });
  setSettings(document_.project().output);
  showPage();
}

void OutputDialog::arrange() {
  for (const auto& [widget, name] :
       std::initializer_list<std::pair<QWidget*, const char*>>{{tcp_, "outputTcp"},
                                                               {web_, "outputWeb"},
                                                               {osc_, "outputOsc"},
                                                               {tuio_, "outputTuio"},
                                                               {csv_, "outputCsv"},
                                                               {rate_, "outputRate"},
                                                               {token_, "outputToken"},
                                                               {problem_, "outputProblem"}}) {
    widget->setObjectName(QLatin1String(name));
  }
  intro_->setWordWrap(true);
  problem_->setWordWrap(true);
  problem_->hide();
  page_->setOpenExternalLinks(true);
  page_->setFocusPolicy(Qt::NoFocus);
  rate_->setRange(0, static_cast<int>(OutputSettings::kMaxFramesPerSecond));
  token_->setMaxLength(static_cast<int>(OutputSettings::kMaxTokenBytes));
  auto* web = new QHBoxLayout;
  web->addWidget(webPort_);
  web->addWidget(page_, 1);
  form_->setSpacing(8);
  form_->addRow(tcp_, tcpPort_);
  form_->addRow(web_, web);
  for (QWidget* field :
       std::initializer_list<QWidget*>{osc_, tuio_, csv_, listen_, axes_, unit_, rate_, token_}) {
    field->setMinimumWidth(kFieldWidth);
    form_->addRow(new QLabel(this), field);
    static_cast<QLabel*>(form_->labelForField(field))->setBuddy(field);
  }
  for (QAbstractButton* button : buttons_->buttons()) {
    button->setIcon({}); // as in the other dialogs
  }
  osc_->setPlaceholderText(QStringLiteral("127.0.0.1:9000"));
  tuio_->setPlaceholderText(QStringLiteral("127.0.0.1:3333"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(intro_);
  column->addLayout(form_);
  column->addWidget(problem_);
  column->addWidget(buttons_);
}

void OutputDialog::setSettings(const OutputSettings& settings) {
  showPort(*tcp_, *tcpPort_, settings.tcpPort);
  showPort(*web_, *webPort_, settings.webSocketPort);
  osc_->setText(QString::fromStdString(settings.oscReceiver));
  tuio_->setText(QString::fromStdString(settings.tuioReceiver));
  csv_->setText(QString::fromStdString(settings.csvFile));
  const QString listen = QString::fromStdString(settings.listenAddress);
  if (listen_->findData(listen) < 0) {
    listen_->addItem(listen, listen); // an address of the project file
  }
  listen_->setCurrentIndex(listen_->findData(listen));
  axes_->setCurrentIndex(static_cast<int>(settings.axes));
  unit_->setCurrentIndex(static_cast<int>(settings.unit));
  rate_->setValue(static_cast<int>(settings.framesPerSecond));
  token_->setText(QString::fromStdString(settings.token));
}

OutputSettings OutputDialog::settings() const {
  OutputSettings settings = document_.project().output;
  settings.tcpPort = portOf(*tcp_, *tcpPort_);
  settings.webSocketPort = portOf(*web_, *webPort_);
  settings.oscReceiver = osc_->text().trimmed().toStdString();
  settings.tuioReceiver = tuio_->text().trimmed().toStdString();
  settings.csvFile = csv_->text().trimmed().toStdString();
  settings.listenAddress = listen_->currentData().toString().toStdString();
  settings.axes = static_cast<OutputAxes>(axes_->currentIndex());
  settings.unit = static_cast<OutputUnit>(unit_->currentIndex());
  settings.framesPerSecond = rate_->value();
  settings.token = token_->text().toStdString();
  return settings;
}

void OutputDialog::apply() {
  const auto edited = document_.edit(tr("Change outputs"),
                                     [this](Project& project) { project.output = settings(); });
  problem_->setVisible(!edited);
  if (edited) {
    accept();
  } else {
    problem_->setText(errorText(edited.error()));
  }
}

void OutputDialog::retranslateUi() {
  setWindowTitle(tr("Outputs – Dewpoint"));
  intro_->setText(tr("Choose where results are sent during a run. Nothing is sent before you "
                     "choose Run › Send results."));
  tcp_->setText(tr("TCP port for JSON lines"));
  tcp_->setToolTip(tr("Programs that connect to this port get one line of JSON for each frame"));
  tcpPort_->setAccessibleName(tr("TCP port"));
  tcpPort_->setToolTip(tcp_->toolTip());
  web_->setText(tr("Port for WebSocket and web page"));
  web_->setToolTip(tr("Port of a web page that shows the targets in a browser. At the same port, "
                      "programs get the results through a WebSocket"));
  webPort_->setAccessibleName(tr("WebSocket port"));
  webPort_->setToolTip(web_->toolTip());
  const auto row = [this](QWidget* field, const QString& label, const QString& tip) {
    static_cast<QLabel*>(form_->labelForField(field))->setText(label);
    field->setAccessibleName(label);
    field->setToolTip(tip);
  };
  row(osc_, tr("OSC to"),
      tr("Computer and UDP port that OSC messages are sent to, such as 127.0.0.1:9000. Empty: "
         "off"));
  row(tuio_, tr("TUIO to"),
      tr("Computer and UDP port that TUIO 1.1 3D cursors are sent to, such as 127.0.0.1:3333. "
         "Empty: off"));
  row(csv_, tr("CSV file"),
      tr("File or named pipe that gets one line for each target and frame. Empty: off"));
  row(listen_, tr("Who can connect"),
      tr("Which computers can connect to the ports. If you allow all computers, anyone in the "
         "network can see the results"));
  row(axes_, tr("Axes"), tr("Axes of the positions that are sent"));
  row(unit_, tr("Unit"), tr("Unit of the positions that are sent"));
  row(rate_, tr("Max. frames per second"),
      tr("Largest number of frames per second that are sent. 0: all frames"));
  row(token_, tr("Token for remote commands"),
      tr("Programs that send this word can start and stop the run and the recording of the "
         "cameras. At least %1 characters. Empty: commands are ignored")
          .arg(OutputSettings::kMinTokenBytes));
  setChoicesWithData(*listen_,
                     {{tr("this computer only"), QLatin1String(kThisComputer)},
                      {tr("all computers in the network"), QLatin1String(kAllComputers)}});
  setChoices(*axes_, {tr("z up, right-handed (as in Dewpoint)"), tr("y up, right-handed"),
                      tr("y up, left-handed (as in Unity)")});
  setChoices(*unit_, {tr("meters"), tr("millimeters")});
  setSettings(settings());
}

} // namespace dewpoint::ui
