// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/live_page.h"

#include "core/base/markup.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>
#include <utility>

namespace dewpoint::broadcast {
namespace {

// Names in double braces stand for texts (filled()).
constexpr std::string_view kLivePage = R"html(<!DOCTYPE html>
<html lang="{{language}}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{title}}</title>
<link rel="icon" href="data:,">
<style>
  :root { color-scheme: light dark; --back: #f4f6f6; --ink: #16211f; --faint: #7d8a87; --panel: #ffffffd8; }
  @media (prefers-color-scheme: dark) {
    :root { --back: #111817; --ink: #e6eeec; --faint: #7f8f8b; --panel: #1a2422d8; }
  }
  html, body { margin: 0; height: 100%; overflow: hidden; background: var(--back); color: var(--ink);
               font: 15px/1.4 system-ui, sans-serif; }
  canvas { position: fixed; inset: 0; width: 100%; height: 100%; touch-action: none; }
  #panel { position: fixed; left: 8px; top: 8px; max-width: calc(100vw - 40px); max-height: 45vh;
           overflow: auto; padding: 8px 12px; border-radius: 8px; background: var(--panel); }
  #status { color: var(--faint); }
  ul { list-style: none; margin: 4px 0 0; padding: 0; font-variant-numeric: tabular-nums; }
  li { white-space: nowrap; }
  li .dot { display: inline-block; width: 10px; height: 10px; border-radius: 5px; margin-right: 6px; }
  li .word { color: var(--faint); margin: 0 8px; }
  #help { position: fixed; right: 8px; bottom: 8px; color: var(--faint); font-size: 12px; }
</style>
</head>
<body>
<canvas id="view" role="img" aria-label="{{view}}"></canvas>
<div id="panel"><div id="status" role="status">{{connecting}}</div><ul id="targets"></ul></div>
<div id="help">{{help}}</div>
<script>
"use strict";
(() => {
const canvas = document.getElementById("view"), draw = canvas.getContext("2d");
const status = document.getElementById("status"), list = document.getElementById("targets");
const COLORS = ["#e0457b", "#2a9d8f", "#e9a23b", "#4a7fd6", "#8e63ce", "#62a532", "#d1603d", "#5aa9b8"];
const TEXTS = {{texts}};
const TRAIL = 300;                 // positions of a track that are drawn
let rig = null, frame = null, frames = 0, needsDrawing = true;
const trails = new Map();          // id -> positions, oldest first; null is a gap
const home = { turn: -0.9, tilt: 0.45, zoom: 1 };
let eye = { ...home }, center = [0, 0, 0], radius = 2;

function number(value, digits) {
  return value.toLocaleString(document.documentElement.lang,
    { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false });
}

function filled(text, ...values) { return text.replace(/%([1-9])/g, (all, place) => values[place - 1] ?? all); }

// Drawn is the world as Dewpoint has it: meters, z up.
function toWorld(p) {
  const s = rig && rig.unit === "mm" ? 0.001 : 1;
  const [x, y, z] = p.map((value) => value * s);
  if (rig && rig.axes === "y-up") return [z, x, y];
  if (rig && rig.axes === "y-up-left-handed") return [x, z, y];
  return [x, y, z];
}

function setRig(message) {
  rig = message;
  trails.clear();
  const points = rig.cameras.map((one) => toWorld(one.position)).concat(rig.volume.map(toWorld));
  const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
  const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
  center = low.map((value, k) => (value + high[k]) / 2);
  radius = Math.max(0.1, Math.hypot(...low.map((value, k) => high[k] - value)) / 2);
}

function setFrame(message) {
  if (frame && message.frame < frame.frame) trails.clear();
  frame = message;
  for (const target of frame.targets) {
    if (!trails.has(target.id)) trails.set(target.id, []);
    const trail = trails.get(target.id);
    trail.push(target.position ? toWorld(target.position) : null);
    if (trail.length > TRAIL) trail.shift();
  }
  document.body.dataset.frames = ++frames;
}

function colorOf(id) { return COLORS[(id - 1) % COLORS.length]; }

function showList() {
  while (list.children.length > frame.targets.length) list.lastChild.remove();
  frame.targets.forEach((target, k) => {
    let row = list.children[k];
    if (!row) {
      row = document.createElement("li");
      for (const name of ["dot", "name", "word", "place"]) {
        row.append(Object.assign(document.createElement("span"), { className: name }));
      }
      list.append(row);
    }
    const [dot, name, word, place] = row.children;
    dot.style.background = colorOf(target.id);
    name.textContent = target.name;
    word.textContent = TEXTS.states[target.state] || target.state;
    const digits = rig && rig.unit === "mm" ? 0 : 3;
    place.textContent = target.position
      ? target.position.map((value) => number(value, digits)).join("  ") + " " + (rig ? rig.unit : "") : "";
  });
}

// Where a point of the world appears: [x, y, depth] in pixels, or null behind the eye.
function project(p) {
  const d = p.map((value, k) => value - center[k]);
  const ct = Math.cos(eye.turn), st = Math.sin(eye.turn), ci = Math.cos(eye.tilt), si = Math.sin(eye.tilt);
  const x = -st * d[0] + ct * d[1];
  const along = ct * d[0] + st * d[1];
  const up = ci * d[2] - si * along;
  const depth = 3 * radius / eye.zoom - (ci * along + si * d[2]);
  if (depth < 0.02 * radius) return null;
  const scale = 1.4 * Math.min(canvas.width, canvas.height) / depth;
  return [canvas.width / 2 + x * scale, canvas.height / 2 - up * scale, depth];
}

function line(points, color, width) {
  draw.strokeStyle = color;
  draw.lineWidth = width * devicePixelRatio;
  draw.beginPath();
  let isOpen = false;
  for (const point of points) {
    const seen = point && project(point);
    if (!seen) { isOpen = false; continue; }
    if (isOpen) draw.lineTo(seen[0], seen[1]); else draw.moveTo(seen[0], seen[1]);
    isOpen = true;
  }
  draw.stroke();
}

function label(text, point, color) {
  const seen = project(point);
  if (!seen) return;
  draw.fillStyle = color;
  draw.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
  draw.fillText(text, seen[0] + 9 * devicePixelRatio, seen[1] - 6 * devicePixelRatio);
}

function drawFloor(faint) {
  const step = 10 ** Math.floor(Math.log10(radius / 2)) * (radius / 10 ** Math.floor(Math.log10(radius)) > 4 ? 2.5 : 1);
  const count = Math.min(40, Math.ceil(radius / step));
  const x = Math.round(center[0] / step) * step, y = Math.round(center[1] / step) * step, far = count * step;
  for (let k = -count; k <= count; ++k) {
    line([[x + k * step, y - far, 0], [x + k * step, y + far, 0]], faint + "55", 1);
    line([[x - far, y + k * step, 0], [x + far, y + k * step, 0]], faint + "55", 1);
  }
}

function render() {
  requestAnimationFrame(render);
  if (!needsDrawing) return;
  needsDrawing = false;
  const width = Math.round(innerWidth * devicePixelRatio), height = Math.round(innerHeight * devicePixelRatio);
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  draw.clearRect(0, 0, width, height);
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue("--ink").trim(), faint = style.getPropertyValue("--faint").trim();
  drawFloor(faint);
  for (const camera of rig ? rig.cameras : []) {
    const at = toWorld(camera.position), ahead = toWorld(camera.direction);
    const length = 0.15 * radius / Math.hypot(...ahead);
    line([at, at.map((value, k) => value + length * ahead[k])], ink, 2);
    const seen = project(at);
    if (seen) { draw.fillStyle = ink; draw.fillRect(seen[0] - 4, seen[1] - 4, 8, 8); }
    label(camera.name, at, ink);
  }
  for (const target of frame ? frame.targets : []) {
    const trail = trails.get(target.id), at = trail[trail.length - 1];
    line(trail, colorOf(target.id), 2);
    const seen = at && project(at);
    if (!seen) continue;
    draw.fillStyle = colorOf(target.id);
    draw.beginPath();
    draw.arc(seen[0], seen[1], 7 * devicePixelRatio, 0, 2 * Math.PI);
    draw.fill();
    line([at, [at[0], at[1], 0]], colorOf(target.id) + "66", 1);
    label(target.name, at, ink);
  }
  if (frame) showList();
}

function connect() {
  const socket = new WebSocket(`ws://${location.host}/`);
  socket.onopen = () => { status.textContent = TEXTS.waiting; };
  socket.onmessage = (event) => {
    const message = JSON.parse(event.data);
    if (message.type === "rig") setRig(message);
    if (message.type === "frame") {
      setFrame(message);
      status.textContent = filled(TEXTS.frame, message.frame, filled(TEXTS.seconds, number(message.time, 1)));
    }
    needsDrawing = true;
  };
  socket.onclose = () => {
    status.textContent = TEXTS.disconnected;
    setTimeout(connect, 2000);
  };
}

const fingers = new Map();
let pinch = 0;
canvas.onpointerdown = (event) => { canvas.setPointerCapture(event.pointerId); fingers.set(event.pointerId, event); pinch = 0; };
canvas.onpointerup = canvas.onpointercancel = (event) => { fingers.delete(event.pointerId); pinch = 0; };
canvas.onpointermove = (event) => {
  const before = fingers.get(event.pointerId);
  if (!before) return;
  fingers.set(event.pointerId, event);
  if (fingers.size === 2) {
    const [a, b] = [...fingers.values()], apart = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    if (pinch > 0) zoom(apart / pinch);
    pinch = apart;
  } else {
    eye.turn -= 0.008 * (event.clientX - before.clientX);
    eye.tilt = Math.max(-1.5, Math.min(1.5, eye.tilt + 0.008 * (event.clientY - before.clientY)));
  }
  needsDrawing = true;
};
function zoom(factor) { eye.zoom = Math.max(0.2, Math.min(20, eye.zoom * factor)); needsDrawing = true; }
canvas.onwheel = (event) => { event.preventDefault(); zoom(Math.exp(-0.0015 * event.deltaY)); };
canvas.ondblclick = () => { eye = { ...home }; needsDrawing = true; };
addEventListener("resize", () => { needsDrawing = true; });
connect();
render();
})();
</script>
</body>
</html>
)html";

/// The texts that the script writes, as a value of JavaScript.
std::string scriptTexts(const PageTexts& texts) {
  using nlohmann::json;
  const json value{{"waiting", texts.waiting},
                   {"disconnected", texts.disconnected},
                   {"frame", texts.frame},
                   {"seconds", texts.seconds},
                   {"states", texts.states}};
  std::string script;
  for (const char letter : value.dump(-1, ' ', false, json::error_handler_t::replace)) {
    if (letter == '<') {
      script += "\\u003c"; // nothing in a text ends the script
    } else {
      script += letter;
    }
  }
  return script;
}

/// The page with each name replaced by its value.
template <std::size_t Count>
std::string filled(std::string_view page,
                   const std::array<std::pair<std::string_view, std::string>, Count>& values) {
  std::string text;
  while (!page.empty()) {
    const std::size_t begin = page.find("{{");
    text += page.substr(0, begin);
    if (begin == std::string_view::npos) {
      break;
    }
    const std::size_t end = page.find("}}", begin);
    for (const auto& [name, value] : values) {
      if (name == page.substr(begin + 2, end - begin - 2)) {
        text += value;
      }
    }
    page.remove_prefix(end + 2);
  }
  return text;
}

} // namespace

std::string livePage(const PageTexts& texts) {
  return filled<6>(kLivePage, {{{"language", base::htmlEscaped(texts.language)},
                                {"title", base::htmlEscaped(texts.title)},
                                {"view", base::htmlEscaped(texts.viewDescription)},
                                {"connecting", base::htmlEscaped(texts.connecting)},
                                {"help", base::htmlEscaped(texts.help)},
                                {"texts", scriptTexts(texts)}}});
}

} // namespace dewpoint::broadcast
