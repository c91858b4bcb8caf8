// The scene as text: line numbers, the line of a mistake, and the messages as the program says them.

import { byId, el } from "./dom";
import type { NacrePage } from "./main";
import { offsetOf } from "./toml_text";

const pauseMs = 150;
const mostPainted = 100000;
// A heading, what is neither, and a comment.
const partsOfLine = /^(\s*\[+[^\]=]*\]+)?((?:"[^"]*"|[^"#])*)(#.*)?$/;

export class TextPanel {
  private readonly area = byId<HTMLTextAreaElement>("text-area");
  private readonly colours = byId("text-colours");
  private readonly numbers = byId("text-numbers");
  private painted: string[] = [];
  private timer = 0;

  constructor(private readonly page: NacrePage) {
    this.area.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.paint();
      this.timer = window.setTimeout(() => page.doc.replace(this.area.value, "typing"), pauseMs);
    });
    this.area.addEventListener("scroll", () => this.follow());
  }

  show(): void {
    const { doc } = this.page;
    if (document.body.classList.contains("text-folded")) return;
    if (this.area.value !== doc.text) {
      const { selectionStart, selectionEnd } = this.area;
      this.area.value = doc.text;
      if (document.activeElement === this.area) this.area.setSelectionRange(selectionStart, selectionEnd);
    }
    const messages = doc.opened.mistakes.map(({ message, line, column }) => {
      const jump = (): void => {
        this.area.focus();
        this.area.selectionStart = this.area.selectionEnd = offsetOf(this.area.value, line, column);
      };
      const said = message.replace("scene.toml:", "");
      return el("li", { class: "mistake" }, line === 0 ? message : el("button", { click: jump }, said));
    });
    const warnings = doc.opened.warnings.map((text) => el("li", { class: "note" }, text));
    byId("messages").replaceChildren(...messages, ...warnings);
    byId("messages-summary").hidden = messages.length === 0;
    this.paint();
  }

  // The same text below the transparent one of the text area, in colours. Lines that have not changed stay.
  private paint(): void {
    // Of a text that no hand has written the browser would draw for minutes: it stays plain.
    const isLong = this.area.value.length > mostPainted;
    this.area.classList.toggle("plain", isLong);
    if (isLong) {
      for (const column of [this.colours, this.numbers]) column.replaceChildren();
      this.painted = [];
      return;
    }
    const wrong = new Set(this.page.doc.opened.mistakes.map((mistake) => mistake.line));
    const lines = this.area.value.split("\n").map((line, i) => (wrong.has(i + 1) ? `!${line}` : ` ${line}`));
    for (const column of [this.colours, this.numbers]) {
      while (column.children.length > lines.length) column.lastChild!.remove();
      while (column.children.length < lines.length) column.append(el("div", {}, String(column.children.length + 1)));
    }
    lines.forEach((line, i) => {
      if (line === this.painted[i]) return;
      const parts = partsOfLine.exec(line.slice(1)) ?? ["", "", line.slice(1)];
      const kinds = ["heading", "plain", "comment"];
      const spans = kinds.map((kind, part) => el("span", { class: kind }, parts[part + 1] ?? ""));
      this.colours.children[i]!.replaceChildren(...spans, "\u200b");
      for (const column of [this.colours, this.numbers]) {
        column.children[i]!.className = line.startsWith("!") ? "wrong" : "";
      }
    });
    this.painted = lines;
    this.follow();
  }

  private follow(): void {
    this.colours.style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
    this.numbers.style.transform = `translateY(${-this.area.scrollTop}px)`;
  }
}
