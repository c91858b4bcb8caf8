// Changes of a scene's text at the places that nacre gives for its values. All else, comments too, stays as it is.

import type { Place, SceneValue } from "./api";

export type TomlValue = number | string | boolean | string[] | { toml: string };
type Values = Record<string, SceneValue>;

/** Characters begin to end are replaced. */
type Edit = { begin: number; end: number; text: string };

function inToml(value: TomlValue): string {
  if (typeof value === "number") return String(Number(value.toPrecision(7)));
  if (Array.isArray(value)) return `[${value.map((item) => JSON.stringify(item)).join(", ")}]`;
  return typeof value === "object" ? value.toml : JSON.stringify(value);
}

/** Lines and columns count from 1, columns in characters of Unicode. */
export function offsetOf(text: string, line: number, column: number): number {
  let start = 0;
  for (let at = 1; at < line; ++at) start = text.indexOf("\n", start) + 1;
  return start + [...text.slice(start, endOfLine(text, start))].slice(0, column - 1).join("").length;
}

function spanOf(text: string, place: Place): { begin: number; end: number } {
  return { begin: offsetOf(text, place.line, place.column), end: offsetOf(text, place.endLine, place.endColumn) };
}

function endOfLine(text: string, offset: number): number {
  const end = text.indexOf("\n", offset);
  return end < 0 ? text.length : end;
}

const isAssigned = (text: string, begin: number): boolean => text.slice(0, begin).trimEnd().endsWith("=");

/** "a.b[0].c" as "a.b[0]" and "c". */
function parentAndKey(path: string): [string, string] {
  const parts = /^(.*)\.("(?:[^"\\]|\\.)*"|[\w-]+)$/s.exec(path);
  return parts ? [parts[1]!, parts[2]!] : ["", path];
}

// Behind the last key of a table that stands under a heading.
function endOfTable(text: string, values: Values, table: string, heading: number): number {
  const ends = Object.keys(values)
    .filter((path) => parentAndKey(path)[0] === table)
    .map((path) => spanOf(text, values[path]!.place))
    .map(({ begin, end }) => (isAssigned(text, begin) ? end : 0));
  return endOfLine(text, Math.max(heading, ...ends));
}

function insertion(text: string, values: Values, path: string, literal: string): Edit {
  const [parent, key] = parentAndKey(path);
  const table = values[parent];
  const span = table && table.place.line > 0 ? spanOf(text, table.place) : undefined;
  const at = (offset: number, added: string): Edit => ({ begin: offset, end: offset, text: added });
  if (!span) return at(text.length, `${text.endsWith("\n") ? "" : "\n"}\n[${parent}]\n${key} = ${literal}\n`);
  if (text[span.begin] === "{") {
    const inside = text.slice(span.begin + 1, span.end - 1).trimEnd();
    return at(span.begin + 1 + inside.length, `${inside === "" ? "" : ","} ${key} = ${literal}`);
  }
  const name = text[span.begin] === "[" ? key : path;
  return at(endOfTable(text, values, parent, span.begin), `\n${name} = ${literal}`);
}

function applied(text: string, edits: Edit[]): string {
  const fromTheEnd = edits.map((edit, order) => ({ ...edit, order }));
  fromTheEnd.sort((a, b) => b.begin - a.begin || b.order - a.order);
  for (const edit of fromTheEnd) text = text.slice(0, edit.begin) + edit.text + text.slice(edit.end);
  return text;
}

/** The text with other values. Keys and tables that are missing are inserted.
 *  @param table  the keys of `changes` are of this one; "" if they are paths */
export function withValues(text: string, values: Values, changes: Record<string, TomlValue>, table = ""): string {
  const edits = Object.entries(changes).map(([key, value]) => {
    const path = table === "" ? key : `${table}.${key}`;
    const known = values[path];
    return known ? { ...spanOf(text, known.place), text: inToml(value) } : insertion(text, values, path, inToml(value));
  });
  return applied(text, edits);
}

/** The text with one more item at the end of an array. */
export function withItem(text: string, values: Values, array: string, literal: string): string {
  let count = 0;
  while (values[`${array}[${count}]`]) ++count;
  const last = values[`${array}[${count - 1}]`];
  if (!last) return withValues(text, values, { [array]: { toml: `[${literal}]` } });
  const { begin, end } = spanOf(text, last.place);
  const whole = spanOf(text, values[array]!.place);
  if (!isAssigned(text, whole.begin)) return text;
  const rest = text.slice(end, whole.end - 1);
  if (!rest.includes("\n")) return applied(text, [{ begin: end, end, text: `, ${literal}` }]);
  const indent = /^[ \t]*/.exec(text.slice(text.lastIndexOf("\n", begin) + 1))![0];
  const comma = rest.replace(/#.*$/gm, "").includes(",") ? "," : "";
  const lineEnd = endOfLine(text, end);
  const added = { begin: lineEnd, end: lineEnd, text: `\n${indent}${literal}${comma}` };
  return applied(text, [{ begin: end, end, text: comma === "" ? "," : "" }, added]);
}

/** The text without a value: a key of a table, or an item of an array. */
export function without(text: string, values: Values, path: string): string {
  if (!values[path]) return text;
  let { begin, end } = spanOf(text, values[path]!.place);
  const key = /(?:"[^"\n]*"|[\w.-]+)\s*=\s*$/.exec(text.slice(0, begin));
  if (key) begin = key.index;
  const after = /^\s*,[ \t]*/.exec(text.slice(end));
  if (after) end += after[0].length;
  else begin -= /(?:,\s*)?$/.exec(text.slice(0, begin))![0].length;
  const lineStart = text.lastIndexOf("\n", begin - 1) + 1;
  const lineEnd = endOfLine(text, end);
  const isAlone = (text.slice(lineStart, begin) + text.slice(end, lineEnd)).trim() === "";
  return isAlone ? text.slice(0, lineStart) + text.slice(lineEnd + 1) : text.slice(0, begin) + text.slice(end);
}
