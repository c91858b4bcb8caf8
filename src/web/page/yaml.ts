// Material files for the module: yaml_of_page.cpp asks for the tree of a YAML text, as JSON.

import { isAlias, isMap, isScalar, isSeq, LineCounter, parseDocument, type Node } from "yaml";

type Tree =
  | { kind: "nothing"; line: number }
  | { kind: "text"; line: number; textLine: number; text: string }
  | { kind: "list"; line: number; items: Tree[] }
  | { kind: "map"; line: number; keys: string[]; items: Tree[] };

// The limits that the program has (io/scene/yaml_tree.h).
const MOST_LEVELS = 32;
const MOST_VALUES = 10000;

class TreeMaker {
  private values = 0;

  constructor(private readonly lines: LineCounter) {}

  tree(node: unknown, parentLine: number, level = 0): Tree {
    if (++this.values > MOST_VALUES) throw new TreeError(`more than ${MOST_VALUES} values`, parentLine);
    if (level >= MOST_LEVELS) throw new TreeError(`more than ${MOST_LEVELS} levels`, parentLine);
    const range = (node as Node | null)?.range;
    const line = range ? this.lines.linePos(range[0]).line : parentLine;
    if (isAlias(node)) throw new TreeError("has an alias (*); write its value out", line);
    if (isSeq(node)) return { kind: "list", line, items: node.items.map((item) => this.tree(item, line, level + 1)) };
    if (isMap(node)) {
      const keys = node.items.map((item) => {
        if (!isScalar(item.key)) throw new TreeError("a key is not a word; a key must be a word", line);
        return String(item.key.value);
      });
      return { kind: "map", line, keys, items: node.items.map((item) => this.tree(item.value, line, level + 1)) };
    }
    if (!isScalar(node) || node.value === null || node.source === "") return { kind: "nothing", line };
    const isBlock = node.type === "BLOCK_LITERAL" || node.type === "BLOCK_FOLDED";
    return { kind: "text", line, textLine: line + (isBlock ? 1 : 0), text: String(node.value) };
  }
}

class TreeError extends Error {
  constructor(message: string, readonly line: number) {
    super(message);
  }
}

/** The tree of a text's one document as JSON, or { error, line }. Every value is a text: what numbers mean is nacre's. */
export function parseYaml(text: string): string {
  const lines = new LineCounter();
  const document = parseDocument(text.replaceAll("\t", " "), { lineCounter: lines, schema: "failsafe" });
  const error = document.errors[0];
  if (error) {
    const summary = error.message.split("\n")[0] ?? "";
    return JSON.stringify({ error: `is not YAML: ${summary}`, line: error.linePos?.[0].line ?? 1 });
  }
  try {
    return JSON.stringify(new TreeMaker(lines).tree(document.contents, 1));
  } catch (failure) {
    if (failure instanceof TreeError) return JSON.stringify({ error: failure.message, line: failure.line });
    throw failure;
  }
}
