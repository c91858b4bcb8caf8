// The scene as text: line numbers, the line of a mistake, and the messages as the program says them.

import { byId, el } from "./dom";
import type { Page } from "./page";
import { offsetOf } from "./toml_text";

const pauseMs = 150;

export class TextPanel {
  private readonly area = byId<HTMLTextAreaElement>("text-area");
  private readonly colours = byId("text-colours");
  private readonly numbers = byId("text-numbers");
  private timer = 0;

  constructor(private readonly page: Page) {
    this.area.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.paint();
      this.timer = window.setTimeout(() => page.doc.replace(this.area.value, "typing"), pauseMs);
    });
    this.area.addEventListener("scroll", () => this.follow());
  }

  show(): void {
    const { doc } = this.page;
    if (this.area.value !== doc.text) {
      const { selectionStart, selectionEnd } = this.area;
      this.area.value = doc.text;
      if (document.activeElement === this.area) this.area.setSelectionRange(selectionStart, selectionEnd);
    }
    const { mistakes, warnings } = doc.opened;
    const messages = mistakes.map(({ message, line, column }) => {
      const jump = (): void => this.jump(line, column);
      const text = message.replace(/^scene\.toml:/, line > 0 ? "" : "$&");
      return el("li", { class: "mistake" }, line > 0 ? el("button", { click: jump }, text) : text);
    });
    const cautions = [...warnings, ...(this.page.baked?.warnings ?? [])];
    byId("messages").replaceChildren(...messages, ...cautions.map((text) => el("li", { class: "warning" }, text)));
    byId("messages-summary").textContent =
      mistakes.length === 0 ? "" : "The panels show the last text without mistakes.";
    this.paint();
  }

  private jump(line: number, column: number): void {
    const at = offsetOf(this.area.value, line, column);
    this.area.focus();
    this.area.setSelectionRange(at, at);
  }

  // The same text below the transparent one of the text area, in colours.
  private paint(): void {
    const wrong = new Set(this.page.doc.opened.mistakes.map((mistake) => mistake.line));
    const lines = this.area.value.split("\n");
    this.colours.replaceChildren(
      ...lines.map((line, i) => {
        const parts = /^(\s*\[+[^\]=]*\]+)?((?:"[^"]*"|[^"#])*)(#.*)?$/.exec(line) ?? [line, "", line, ""];
        const spans = ["heading", "plain", "comment"].map((kind, part) =>
          el("span", { class: kind }, parts[part + 1] ?? ""),
        );
        return el("div", { class: wrong.has(i + 1) ? "wrong" : "" }, ...spans, "\u200b");
      }),
    );
    this.numbers.replaceChildren(
      ...lines.map((_, i) => el("div", { class: wrong.has(i + 1) ? "wrong" : "" }, String(i + 1))),
    );
    this.follow();
  }

  private follow(): void {
    this.colours.style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
    this.numbers.style.transform = `translateY(${-this.area.scrollTop}px)`;
  }
}
