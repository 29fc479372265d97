// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement for a Worker that runs in a hidden frame of the page. If a page comes from a folder, browsers
// refuse real workers. The search of the theme looks for a class of this name and then uses it instead.
class IFrameWorker extends EventTarget {
  constructor(address) {
    super();
    const frame = document.createElement("iframe");
    frame.hidden = true;
    document.body.appendChild(frame);
    const scope = frame.contentWindow;
    const load = source => new Promise((resolve, reject) => {
      const script = scope.document.createElement("script");
      script.src = source;
      script.onload = resolve;
      script.onerror = reject;
      scope.document.head.appendChild(script);
    });
    scope.postMessage = data => this.dispatchEvent(new MessageEvent("message", {data}));
    scope.importScripts = (...sources) =>
      sources.reduce((before, source) => before.then(() => load(source)), Promise.resolve());
    this.scope = scope;
    this.ready = load(new URL(address, location.href).href);
  }

  postMessage(data) {
    this.ready.then(() => this.scope.dispatchEvent(new MessageEvent("message", {data})));
  }
}
window.Worker = window.IFrameWorker = IFrameWorker;
