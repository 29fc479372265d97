// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes Boost: its templates take a while to compile.
#include "core/broadcast/transport/web_server.h"

#include "core/broadcast/transport/live_page.h"
#include "core/broadcast/transport/outgoing_queue.h"

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace dewpoint::broadcast {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = net::ip::tcp;
using Request = http::request<http::empty_body>;

constexpr std::size_t kMaxHeaderBytes = 8192;
constexpr std::size_t kMaxWaitingPieces = 4096;

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

/// What the connections of one server share. Used by its thread, except for the numbers.
struct WebHub {
  std::shared_ptr<RemoteCommandFilter> gate;
  bool isLoopback = true;
  std::string preamble;
  PageTexts texts;
  std::set<class WebClient*> clients;
  int connections = 0; ///< also those that only look at the page
  std::atomic<int> clientCount = 0;
  std::atomic<std::int64_t> sent = 0;
  std::atomic<std::int64_t> dropped = 0;
};

/// Counts a connection for as long as it exists.
class WebConnection {
public:
  explicit WebConnection(WebHub& hub) : hub_(&hub) { ++hub_->connections; }
  ~WebConnection() { --hub_->connections; }
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;

private:
  WebHub* hub_;
};
using WebConnectionPtr = std::shared_ptr<WebConnection>;

/// A program or page that is connected by WebSocket.
class WebClient : public std::enable_shared_from_this<WebClient> {
public:
  WebClient(WebHub& hub, beast::tcp_stream&& stream, WebConnectionPtr connection)
      : hub_(hub), stream_(std::move(stream)), connection_(std::move(connection)) {}
  ~WebClient() { leave(); }
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  void accept(const Request& request) {
    beast::get_lowest_layer(stream_).expires_never(); // from here on, WebSocket has its own timeout
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = std::chrono::seconds(WebServer::kRequestTimeoutSeconds);
    timeout.idle_timeout = std::chrono::seconds(30);
    timeout.keep_alive_pings = true;
    stream_.set_option(timeout);
    stream_.read_message_max(kMaxRemoteCommandBytes);
    stream_.text(true);
    stream_.auto_fragment(false); // simple clients read one frame as one message
    stream_.async_accept(request, [self = shared_from_this()](beast::error_code problem) {
      if (!problem) {
        self->join();
        self->read();
      }
    });
  }

  void push(SharedBytes bytes) {
    hub_.dropped += queue_.push(std::move(bytes));
    if (!isWriting_) {
      write();
    }
  }

  void close() { beast::get_lowest_layer(stream_).close(); }

private:
  void join() {
    hub_.clients.insert(this);
    hub_.clientCount = static_cast<int>(hub_.clients.size());
    if (!hub_.preamble.empty()) {
      push(std::make_shared<const std::string>(hub_.preamble));
    }
  }
  void leave() {
    hub_.clients.erase(this);
    hub_.clientCount = static_cast<int>(hub_.clients.size());
  }

  void read() {
    stream_.async_read(input_, [self = shared_from_this()](beast::error_code problem, std::size_t) {
      if (problem) {
        self->leave();
        self->close();
        return;
      }
      const std::string line = beast::buffers_to_string(self->input_.data());
      self->input_.consume(self->input_.size());
      if (const std::string reply = self->hub_.gate->handle(line); !reply.empty()) {
        self->push(std::make_shared<const std::string>(reply));
      }
      self->read();
    });
  }

  void write() {
    if (queue_.empty()) {
      return;
    }
    isWriting_ = true;
    const SharedBytes piece = queue_.front();
    stream_.async_write(net::buffer(*piece),
                        [self = shared_from_this(), piece](beast::error_code problem, std::size_t) {
                          self->isWriting_ = false;
                          if (problem) {
                            self->leave();
                            self->close();
                            return;
                          }
                          ++self->hub_.sent;
                          self->queue_.pop();
                          self->write();
                        });
  }

  WebHub& hub_;
  websocket::stream<beast::tcp_stream> stream_;
  WebConnectionPtr connection_;
  beast::flat_buffer input_;
  OutgoingQueue queue_;
  bool isWriting_ = false;
};

/// A connection before it is known what it wants.
class WebVisit : public std::enable_shared_from_this<WebVisit> {
public:
  WebVisit(WebHub& hub, Tcp::socket&& socket)
      : hub_(hub), connection_(std::make_shared<WebConnection>(hub)), stream_(std::move(socket)) {
    parser_.header_limit(kMaxHeaderBytes);
  }

  void read() {
    stream_.expires_after(std::chrono::seconds(WebServer::kRequestTimeoutSeconds));
    http::async_read(stream_, input_, parser_,
                     [self = shared_from_this()](beast::error_code problem, std::size_t) {
                       if (!problem) {
                         self->answer(self->parser_.get());
                       }
                     });
  }

private:
  void answer(const Request& request) {
    const std::string_view host = view(request[http::field::host]);
    const std::string_view origin = view(request[http::field::origin]);
    const std::string_view target = view(request.target());
    if (!isAllowedOrigin(host, origin, hub_.isLoopback)) {
      refuse(request, http::status::forbidden, hub_.texts.otherSiteRefused);
    } else if (websocket::is_upgrade(request)) {
      std::make_shared<WebClient>(hub_, std::move(stream_), connection_)->accept(request);
    } else if (request.method() != http::verb::get && request.method() != http::verb::head) {
      refuse(request, http::status::method_not_allowed, hub_.texts.onlyGetSupported);
    } else if (target == "/" || target.starts_with("/?")) {
      respond(request, http::status::ok, livePage(hub_.texts), "text/html; charset=utf-8");
    } else {
      refuse(request, http::status::not_found, hub_.texts.pageNotFound);
    }
  }

  void refuse(const Request& request, http::status status, const std::string& reason) {
    respond(request, status, reason + "\n", "text/plain; charset=utf-8");
  }

  void respond(const Request& request, http::status status, std::string_view body,
               const char* type) {
    response_.emplace(status, request.version());
    response_->set(http::field::server, "Dewpoint");
    response_->set(http::field::content_type, type);
    response_->set(http::field::cache_control, "no-store");
    response_->set("Content-Security-Policy",
                   "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                   "img-src data:; connect-src 'self' ws:; frame-ancestors 'none'");
    response_->set("X-Content-Type-Options", "nosniff");
    response_->keep_alive(false);
    response_->content_length(body.size());
    if (request.method() != http::verb::head) {
      response_->body() = std::string(body);
    }
    http::async_write(stream_, *response_,
                      [self = shared_from_this()](beast::error_code, std::size_t) {
                        beast::error_code ignored;
                        self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                      });
  }

  WebHub& hub_;
  WebConnectionPtr connection_;
  beast::tcp_stream stream_;
  beast::flat_buffer input_{2 * kMaxHeaderBytes};
  http::request_parser<http::empty_body> parser_;
  std::optional<http::response<http::string_body>> response_;
};

std::string endpointText(const Tcp::endpoint& endpoint) {
  const std::string host = endpoint.address().to_string();
  return (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" +
         std::to_string(endpoint.port());
}

} // namespace

bool isAllowedOrigin(std::string_view host, std::string_view origin, bool isLoopback) {
  if (!origin.empty() && origin != "http://" + std::string(host)) {
    return false;
  }
  const auto end = host.starts_with('[') ? host.find(']') + 1 : host.find(':');
  const std::string_view name = host.substr(0, end);
  return !isLoopback || name == "localhost" || name == "[::1]" || name.starts_with("127.");
}

class WebServer::Impl {
public:
  Impl(const Tcp::endpoint& endpoint, std::shared_ptr<RemoteCommandFilter> gate,
       const PageTexts& texts)
      : acceptor_(context_, endpoint), retry_(context_), place_(acceptor_.local_endpoint()) {
    hub_.gate = std::move(gate);
    hub_.texts = texts;
    hub_.isLoopback = place_.address().is_loopback();
    accept();
    thread_ = std::jthread([this] { run(); });
  }
  ~Impl() {
    context_.stop();
    thread_.join();
    hub_.clients.clear();
  }

  void setPageTexts(const PageTexts& texts) {
    net::post(context_, [this, texts] { hub_.texts = texts; });
  }

  void setPreamble(const std::string& preamble) {
    net::post(context_, [this, preamble] {
      if (hub_.preamble != preamble) {
        hub_.preamble = preamble;
        give(std::make_shared<const std::string>(preamble));
      }
    });
  }

  void send(const std::vector<std::string>& pieces) {
    const std::lock_guard lock(mutex_);
    const bool wasEmpty = pending_.empty();
    for (const std::string& piece : pieces) {
      if (pending_.size() >= kMaxWaitingPieces) {
        pending_.pop_front();
        ++hub_.dropped;
      }
      pending_.push_back(std::make_shared<const std::string>(piece));
    }
    if (wasEmpty && !pending_.empty()) {
      net::post(context_, [this] { distribute(); });
    }
  }

  OutletReport report() const {
    return {OutletKind::WebPage, "http://" + endpointText(place_) + "/", hub_.clientCount,
            hub_.sent, hub_.dropped};
  }
  std::uint16_t port() const { return place_.port(); }

private:
  void run() {
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception&) {
        // Memory ran out for one connection, which is gone with its handler; the others go on.
      }
    }
  }

  void accept() {
    acceptor_.async_accept([this](beast::error_code problem, Tcp::socket socket) {
      if (problem) {
        // Out of descriptors: until one is free, the connection would be there all the time.
        retry_.expires_after(std::chrono::milliseconds(100));
        retry_.async_wait([this](beast::error_code) { accept(); });
        return;
      }
      if (hub_.connections < static_cast<int>(kMaxClients)) {
        beast::error_code ignored;
        socket.set_option(Tcp::no_delay(true), ignored);
        std::make_shared<WebVisit>(hub_, std::move(socket))->read();
      }
      accept();
    });
  }

  void give(const SharedBytes& piece) {
    const std::set<WebClient*> clients = hub_.clients; // one may leave
    for (WebClient* client : clients) {
      if (hub_.clients.contains(client)) {
        client->push(piece);
      }
    }
  }

  void distribute() {
    std::deque<SharedBytes> pending;
    {
      const std::lock_guard lock(mutex_);
      pending.swap(pending_);
    }
    for (const SharedBytes& piece : pending) {
      give(piece);
    }
  }

  WebHub hub_; // first: connections in handlers that never ran still use it
  net::io_context context_{1};
  Tcp::acceptor acceptor_;
  net::steady_timer retry_;
  Tcp::endpoint place_;
  std::mutex mutex_;
  std::deque<SharedBytes> pending_;
  std::jthread thread_;
};

Result<std::unique_ptr<WebServer>> WebServer::open(const std::string& host, std::uint16_t port,
                                                   std::shared_ptr<RemoteCommandFilter> gate,
                                                   const PageTexts& texts) {
  try {
    const Tcp::endpoint endpoint(net::ip::make_address(host), port);
    return std::unique_ptr<WebServer>(
        new WebServer(std::make_unique<Impl>(endpoint, std::move(gate), texts)));
  } catch (const boost::system::system_error& error) {
    return failure(ErrorCode::BadValue, "", "",
                   "port " + std::to_string(port) + " on " + host +
                       " cannot be opened: " + error.code().message());
  }
}

WebServer::WebServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebServer::~WebServer() = default;

void WebServer::setPageTexts(const PageTexts& texts) {
  impl_->setPageTexts(texts);
}
void WebServer::setPreamble(const std::string& preamble) {
  impl_->setPreamble(preamble);
}
void WebServer::send(const std::vector<std::string>& pieces) {
  impl_->send(pieces);
}
OutletReport WebServer::report() const {
  return impl_->report();
}
std::uint16_t WebServer::port() const {
  return impl_->port();
}

} // namespace dewpoint::broadcast
