// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/report_style.h"

namespace dewpoint::experiment {

std::string reportStyleSheet() {
  return R"css(
:root { color-scheme: light dark;
  --page: #fbfbfa; --card: #ffffff; --ink: #1d2127; --soft: #646c77; --rule: #e3e5e8; --grid: #eceef0;
  --good: #1a7f45; --good-back: #e3f4e9; --bad: #b3261e; --bad-back: #fbe9e7; --none-back: #eff0f2;
  --warn: #7a5200; --warn-back: #fff3d6; --ours: #eaf2fb;
  --m0: #0067b8; --m1: #d1570b; --m2: #10936c; --m3: #b354a0; --m4: #a88700; --m5: #666; }
@media (prefers-color-scheme: dark) { :root {
  --page: #15181c; --card: #1c2026; --ink: #e4e7eb; --soft: #98a1ad; --rule: #30363e; --grid: #2a2f37;
  --good: #6fd49a; --good-back: #17341f; --bad: #ff9a8f; --bad-back: #40201d; --none-back: #2a2f36;
  --warn: #ffce6b; --warn-back: #3c2f12; --ours: #1b2a3b;
  --m0: #58a9f0; --m1: #ff9350; --m2: #3fcf9f; --m3: #e08bd0; --m4: #e0c04a; --m5: #aaa; } }
:root { --m6: #0c8a9c; --m7: #7a5cc4; --m8: #7d6b5d; }
@media (prefers-color-scheme: dark) { :root { --m6: #4cc8da; --m7: #a98df0; --m8: #b8a697; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 1240px; margin: 0 auto; padding: 40px 24px 80px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; letter-spacing: -0.01em; }
h2 { font-size: 21px; margin: 52px 0 4px; padding-top: 12px; border-top: 1px solid var(--rule); }
h3 { font-size: 16px; margin: 28px 0 0; }
p { margin: 4px 0 12px; max-width: 78ch; }
.soft, .meta { color: var(--soft); }
.meta { margin: 0; }
nav { margin: 18px 0 0; display: flex; flex-wrap: wrap; gap: 6px 8px; }
nav a { color: var(--ink); text-decoration: none; border: 1px solid var(--rule); background: var(--card);
  border-radius: 999px; padding: 2px 12px; font-size: 13px; }
nav a:hover { border-color: var(--soft); }
.note { background: var(--warn-back); color: var(--warn); border-radius: 8px; padding: 10px 14px; margin: 16px 0; }
.scroll { overflow-x: auto; background: var(--card); border: 1px solid var(--rule); border-radius: 10px; margin: 10px 0 14px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th { color: var(--soft); font-weight: 600; font-size: 12px; text-align: right; padding: 9px 9px; vertical-align: bottom;
  border-bottom: 1px solid var(--rule); line-height: 1.25; }
td { text-align: right; padding: 6px 9px; border-top: 1px solid var(--grid); white-space: nowrap; }
tbody tr:first-child td { border-top: 0; }
th:first-child, td:first-child, th.text, td.text { text-align: left; }
td.text { white-space: normal; }
tr.ours td { background: var(--ours); font-weight: 600; }
td small { color: var(--soft); font-weight: 400; font-size: 11.5px; margin-left: 4px; }
td.best { font-weight: 700; }
.chip { display: inline-block; border-radius: 999px; padding: 0 10px; font-size: 12px; font-weight: 600; background: var(--none-back);
  color: var(--soft); white-space: nowrap; }
.chip.good { background: var(--good-back); color: var(--good); }
.chip.part { background: var(--warn-back); color: var(--warn); }
.chip.bad { background: var(--bad-back); color: var(--bad); }
.count { font-size: 44px; font-weight: 700; line-height: 1; letter-spacing: -0.02em; }
.tiles { display: flex; gap: 14px; flex-wrap: wrap; margin: 14px 0; }
.tile { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 14px 20px; min-width: 150px; }
.tile.good .count { color: var(--good); } .tile.bad .count { color: var(--bad); } .tile .count { color: var(--soft); }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 14px; margin: 10px 0 6px; }
figure { margin: 0; background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 10px 10px 6px; }
.plots figure { max-width: 720px; }
figcaption { font-size: 12.5px; font-weight: 600; margin: 0 0 4px 4px; }
svg { display: block; width: 100%; height: auto; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 18px; font-size: 12.5px; color: var(--soft); margin: 8px 0 0; }
.legend span::before { content: ""; display: inline-block; width: 16px; height: 3px; border-radius: 2px; background: var(--c);
  margin-right: 6px; vertical-align: middle; }
.dot { display: inline-block; width: 9px; height: 9px; border-radius: 50%; background: var(--c); margin-right: 8px; }
.m0 { --c: var(--m0); } .m1 { --c: var(--m1); } .m2 { --c: var(--m2); } .m3 { --c: var(--m3); } .m4 { --c: var(--m4); } .m5 { --c: var(--m5); }
.m6 { --c: var(--m6); } .m7 { --c: var(--m7); } .m8 { --c: var(--m8); }
.grid { stroke: var(--grid); stroke-width: 1; }
.mark { fill: var(--soft); font-size: 10.5px; }
.label { fill: var(--soft); font-size: 11.5px; }
.line { fill: none; stroke: var(--c); stroke-width: 1.5; stroke-linejoin: round; }
.m0 .line { stroke-width: 2.4; }
.band { fill: var(--c); opacity: 0.12; }
.disk { fill: var(--c); opacity: 0.65; }
.guide { stroke: var(--soft); stroke-dasharray: 3 4; fill: none; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; font-size: 13.5px; }
dt { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 12.5px; } dd { margin: 0; color: var(--soft); }
details > summary { cursor: pointer; color: var(--soft); margin: 8px 0; }
@media print { main { max-width: none; padding: 0; } figure, .scroll { break-inside: avoid; } }
)css";
}

} // namespace dewpoint::experiment
