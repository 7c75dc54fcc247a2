// The tables: real ones, sorted by their heads, picked by row.

import { button, el } from "./dom";
import { type Row, type Table, tables } from "./rows";
import type { State } from "./state";

/** Rows shown at first, and more on each request. */
const SHOWN = 300;

export class Tables {
  readonly element = el("section", { id: "tables", "aria-label": "Tables" });
  private name: string | null = null;
  private sorted = { column: -1, descending: false };
  private shown = SHOWN;
  private rows = new Map<number, HTMLTableRowElement>();
  private current: Table | null = null;

  constructor(private state: State, private go: (id: number) => void) {
    this.refresh();
  }

  refresh(): void {
    const all = tables(this.state);
    this.element.hidden = all.length === 0;
    if (!all.length) return;
    const table = all.find((t) => t.name === this.name) ?? all.find((t) => t.rows.length > 0) ?? all[0];
    this.current = table;
    const tabs = all.map((t) => {
      const tab = button(`${t.name} (${t.rows.length})`, `Show the table: ${t.name}`, () => {
        this.name = t.name;
        this.sorted = { column: -1, descending: false };
        this.shown = SHOWN;
        this.refresh();
      });
      tab.setAttribute("aria-pressed", String(t === table));
      return tab;
    });
    this.element.replaceChildren(el("div", { class: "tabs" }, ...tabs), this.body(table));
    this.mark();
  }

  /** Shows which row is picked, and scrolls to it. */
  mark(scroll = false): void {
    const { run, patch, picked: strip } = this.state;
    const picked = { run, patch, strip }[this.current?.pick ?? "strip"];
    for (const [id, row] of this.rows) row.setAttribute("aria-selected", String(id === picked));
    if (scroll && picked !== null) this.rows.get(picked)?.scrollIntoView({ block: "nearest" });
  }

  private body(table: Table): HTMLElement {
    const order = [...table.rows];
    if (this.sorted.column >= 0) order.sort((a, b) => compare(a, b, this.sorted.column));
    if (this.sorted.descending) order.reverse();
    const caption = el("caption", {}, `${table.name}, lengths in the unit of the input`);
    const head = el("tr", {}, ...table.heads.map((text, i) => this.head(text, i)));
    this.rows.clear();
    const rows = order.slice(0, this.shown).map((row) => this.row(table, row));
    const body = el("table", {}, caption, el("thead", {}, head), el("tbody", {}, ...rows));
    const more = order.length - rows.length;
    return el("div", { class: "scroll" }, body, more > 0 ? button(`${more} more rows`, "Show more rows", () => {
      this.shown += SHOWN;
      this.refresh();
    }) : null);
  }

  private head(text: string, column: number): HTMLTableCellElement {
    const sort = button(text, `Sort by ${text}`, () => {
      const again = this.sorted.column === column;
      this.sorted = { column, descending: again && !this.sorted.descending };
      this.refresh();
    });
    const cell = el("th", { scope: "col" }, sort);
    const { column: by, descending } = this.sorted;
    if (by === column) cell.setAttribute("aria-sort", descending ? "descending" : "ascending");
    return cell;
  }

  private row(table: Table, row: Row): HTMLTableRowElement {
    const [first, ...rest] = row.cells;
    const name = button(first[0], `Pick ${first[0]}`, () => this.pick(table, row.id));
    const element = el("tr", {}, el("th", { scope: "row" }, name), ...rest.map(([text]) => el("td", {}, text)));
    element.addEventListener("click", (event) => {
      if (!(event.target instanceof HTMLButtonElement)) this.pick(table, row.id);
    });
    element.addEventListener("pointerenter", () => this.hover(table, row.id));
    element.addEventListener("pointerleave", () => this.hover(table, null));
    this.rows.set(row.id, element);
    return element;
  }

  private pick(table: Table, id: number): void {
    if (table.pick === "run") this.state.run = this.state.run === id ? null : id;
    if (table.pick === "patch") this.state.patch = this.state.patch === id ? null : id;
    if (table.pick === "strip") {
      this.state.picked = this.state.picked === id ? null : id;
      if (this.state.picked !== null) this.go(id);
    }
    this.state.marked();
  }

  private hover(table: Table, id: number | null): void {
    if (table.pick !== "strip") return;
    this.state.hovered = id;
    this.state.marked();
  }
}

function compare(a: Row, b: Row, column: number): number {
  const [x, y] = [a.cells[column][1], b.cells[column][1]];
  if (typeof x === "number" && typeof y === "number") return x - y || a.id - b.id;
  return String(x).localeCompare(String(y), "en", { numeric: true }) || a.id - b.id;
}
