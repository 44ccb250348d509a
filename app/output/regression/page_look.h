#pragma once

#include <string_view>

namespace throng::app {

/// The styles and the program of the page, which stand inside it.
inline constexpr std::string_view page_styles = R"css(
:root { color-scheme: light dark; --text: #1c2024; --faint: #5a6370; --page: #f5f6f8; --card: #fff; --line: #d8dce2;
  --good: #1a7f43; --bad: #c4302b; --other: #8a5a00; --mark: #0b63ce; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e9ee; --faint: #a3acb8; --page: #14171b; --card: #1d2127;
  --line: #363c46; --good: #4cc27d; --bad: #ff7a74; --other: #e0ab4a; --mark: #6eb1ff; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 24px 16px 64px; max-width: 1340px; background: var(--page); color: var(--text);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 22px; margin: 0 0 4px; overflow-wrap: anywhere; }
header p { margin: 0; color: var(--faint); }
details { margin-top: 14px; background: var(--card); border: 1px solid var(--line); border-radius: 8px; }
summary { padding: 10px 14px; cursor: pointer; display: flex; gap: 12px; align-items: baseline; flex-wrap: wrap; }
summary:focus-visible, button:focus-visible, input:focus-visible { outline: 2px solid var(--mark); outline-offset: 2px; }
.word { font-weight: 600; min-width: 86px; color: var(--good); }
.failed, .not-drawn { border-left: 5px solid var(--bad); }
.failed .word, .not-drawn .word { color: var(--bad); }
.left-out .word, .changed .word, .new .word { color: var(--other); }
.name { font-weight: 600; overflow-wrap: anywhere; }
.brief { color: var(--faint); margin-left: auto; }
.inside { padding: 0 14px 14px; }
.message { margin: 0 0 10px; overflow-wrap: anywhere; }
.failed .message, .not-drawn .message { color: var(--bad); }
table { border-collapse: collapse; margin-bottom: 12px; }
th, td { text-align: left; padding: 3px 18px 3px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { font-weight: 500; color: var(--faint); }
td.beyond { color: var(--bad); font-weight: 600; }
.choices { display: flex; gap: 6px; flex-wrap: wrap; margin-bottom: 8px; }
button { font: inherit; padding: 3px 12px; border: 1px solid var(--line); border-radius: 6px; background: none;
  color: inherit; cursor: pointer; }
button[aria-pressed=true] { border-color: var(--mark); color: var(--mark); font-weight: 600; }
.stage { width: max-content; max-width: 100%; }
.stage:has(.large) { max-width: none; }
.frame { position: relative; width: max-content; max-width: 100%; overflow: hidden; border: 1px solid var(--line); }
.frame.large { max-width: none; overflow: visible; }
.frame img { display: block; max-width: 100%; height: auto; }
.frame.large img { max-width: none; image-rendering: pixelated; }
.frame .over { position: absolute; inset: 0; width: 100%; height: 100%; }
[data-shown=slider] .actual { clip-path: inset(0 0 0 var(--at, 50%)); }
[data-shown=expected] .actual, [data-shown]:not([data-shown=difference]) .difference,
[data-shown]:not([data-shown=heat]) .heat, [data-shown]:not([data-shown=slider]) .divider,
[data-shown]:not([data-shown=slider]) .side, [data-shown]:not([data-shown=slider]) ~ .slide, [data-shown]:not([data-shown=heat]) ~ .key { display: none; }
[data-shown=slider] { cursor: ew-resize; touch-action: pan-y; }
.divider { position: absolute; top: 0; bottom: 0; left: var(--at, 50%); width: 2px; margin-left: -1px;
  background: #fff; box-shadow: 0 0 3px #000; pointer-events: none; }
.side { position: absolute; bottom: 8px; padding: 1px 8px; border-radius: 4px; background: rgba(0, 0, 0, .65);
  color: #fff; font-size: 13px; pointer-events: none; }
.side.left { left: 8px; } .side.right { right: 8px; }
.slide { display: block; width: 100%; margin: 6px 0 0; accent-color: var(--mark); }
.wide { overflow-x: auto; }
.key { margin: 6px 0 0; color: var(--faint); font-size: 13px; }
.origin, .command { margin: 8px 0 0; color: var(--faint); font-size: 13px; overflow-wrap: anywhere; }
code { font: 13px/1.4 ui-monospace, monospace; }
)css";

inline constexpr std::string_view page_script = R"js(
for (const view of document.querySelectorAll(".view")) {
  const frame = view.querySelector(".frame"), slide = view.querySelector(".slide");
  const show = what => {
    frame.dataset.shown = what;
    for (const button of view.querySelectorAll("button[data-show]"))
      button.setAttribute("aria-pressed", button.dataset.show === what);
  };
  const move = share => {
    const percent = Math.min(100, Math.max(0, share));
    frame.style.setProperty("--at", percent + "%");
    slide.value = percent;
  };
  for (const button of view.querySelectorAll("button[data-show]"))
    button.addEventListener("click", () => show(button.dataset.show));
  const zoom = view.querySelector("button.zoom");
  if (zoom) zoom.addEventListener("click", () => zoom.setAttribute("aria-pressed", frame.classList.toggle("large")));
  if (!slide) continue;
  slide.addEventListener("input", () => move(Number(slide.value)));
  const follow = event => {
    if (frame.dataset.shown !== "slider" || !(event.buttons & 1)) return;
    const box = frame.getBoundingClientRect();
    move(100 * (event.clientX - box.left) / box.width);
  };
  frame.addEventListener("pointerdown", event => { frame.setPointerCapture(event.pointerId); follow(event); });
  frame.addEventListener("pointermove", follow);
  frame.addEventListener("dragstart", event => event.preventDefault());
}
)js";

}  // namespace throng::app
