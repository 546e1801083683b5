// The viewer: which pictures are shown, how, and what its controls say.

const element = (id) => document.getElementById(id);

function made(name, properties = {}, children = []) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

// Scrolls what holds a chip, and nothing else, until the chip is in sight.
function bringIntoSight(chip) {
  const box = chip.parentElement;
  const [inner, outer] = [chip.getBoundingClientRect(), box.getBoundingClientRect()];
  box.scrollLeft += Math.min(0, inner.left - outer.left) + Math.max(0, inner.right - outer.right);
  box.scrollTop += Math.min(0, inner.top - outer.top) + Math.max(0, inner.bottom - outer.bottom);
}

class Viewer {
  row = null;
  shown = null;
  other = null;
  reference = null;
  layout = "one";
  show = "image";
  // Stops of exposure, and steps of the error scale, from the row's own.
  stops = 0;
  steps = 0;
  turn = 0;

  constructor(data, onShown) {
    this.data = data;
    this.onShown = onShown;
    this.look = new Look();
    const onPixel = (x, y, right) => this.read(x, y, right ? this.other : this.shown);
    this.pane = new Pane(element("v-canvas"), this.look, { onPixel, onSplit: (at) => this.setSplit(at) });
    data.rows.forEach((row, i) => element("v-row").append(new Option(row.title, i)));
    this.listen();
  }

  listen() {
    const on = (id, event, act) => element(id).addEventListener(event, (e) => act(e.target));
    on("v-row", "change", (t) => this.openRow(this.data.rows[t.value]));
    on("v-other", "change", (t) => this.set({ other: this.row.pictures[t.value] }));
    on("v-reference", "change", (t) => this.set({ reference: this.row.pictures[t.value] }));
    on("v-methods", "change", (t) => this.openMethod(t.value));
    on("v-variants", "change", (t) => this.set({ shown: this.row.pictures[t.value] }));
    on("v-exposure", "input", (t) => this.set({ stops: Number(t.value) }));
    on("v-range", "input", (t) => this.set({ steps: Number(t.value) }));
    on("v-split", "input", (t) => this.setSplit(t.value / 100));
    on("v-swap", "click", () => this.swap());
    on("v-fit", "click", () => this.look.set(1, 0.5, 0.5));
    for (const name of ["layout", "show"]) {
      for (const radio of document.getElementsByName(`v-${name}`)) {
        radio.addEventListener("change", () => this.set({ [name]: radio.value }));
      }
    }
  }

  // Opens the picture with this fragment; says whether there is one.
  open(id) {
    for (const row of this.data.rows) {
      const picture = row.pictures.find((p) => p.id === id);
      if (!picture) continue;
      if (row !== this.row) this.beginRow(row);
      this.set({ shown: picture });
      return true;
    }
    return false;
  }

  // Another row: the same method and variant where it has them.
  openRow(row) {
    const like = this.shown;
    this.beginRow(row);
    this.set({ shown: this.nearest(like) });
  }

  beginRow(row) {
    this.row = row;
    [this.other, this.reference] = [row.pictures[0], row.pictures[0]];
    this.stops = 0;
    this.steps = 0;
    element("v-row").value = this.data.rows.indexOf(row);
    for (const id of ["v-other", "v-reference"]) {
      const groups = this.methods().map((method) => {
        const options = this.ofMethod(method).map((p) => new Option(this.name(p), row.pictures.indexOf(p)));
        return made("optgroup", { label: method }, options);
      });
      element(id).replaceChildren(...groups);
    }
    const chips = this.methods().map((method, i) => {
      const first = this.ofMethod(method)[0];
      return this.chip("v-method", method, method, first.hue, i < 9 ? `${i + 1}` : "");
    });
    element("v-methods").replaceChildren(...chips);
  }

  chip(group, value, text, hue, key) {
    const radio = made("input", { type: "radio", name: group, value });
    const span = made("span", {}, key ? [made("kbd", { textContent: key }), ` ${text}`] : [text]);
    return made("label", { className: hue === null ? "" : `hue-${hue}` }, [radio, span]);
  }

  methods() {
    return [...new Set(this.row.pictures.map((p) => p.method))];
  }

  ofMethod(method) {
    return this.row.pictures.filter((p) => p.method === method);
  }

  name(picture) {
    return picture.number ? `${picture.method}, ${picture.variant}` : picture.method;
  }

  // The picture of this row that is most like another.
  nearest(like, method = like?.method) {
    const same = this.row.pictures.filter((p) => p.method === method);
    return same.find((p) => p.variant === like?.variant) ?? this.sameBackend(same, like) ?? this.row.pictures[0];
  }

  sameBackend(pictures, like) {
    const backend = like?.variant.split(",")[0];
    return pictures.find((p) => p.variant.split(",")[0] === backend) ?? pictures[0];
  }

  openMethod(method) {
    this.set({ shown: this.nearest(this.shown, method) });
  }

  // Shows what comes `step` pictures later.
  flip(step) {
    const all = this.row.pictures;
    const at = all.indexOf(this.shown);
    this.set({ shown: all[(at + step + all.length) % all.length] });
  }

  swap() {
    this.set({ shown: this.other, other: this.shown });
  }

  cycle(name, values) {
    this.set({ [name]: values[(values.indexOf(this[name]) + 1) % values.length] });
  }

  setSplit(at) {
    this.pane.split = Math.min(Math.max(at, 0), 1);
    element("v-split").value = 100 * this.pane.split;
    this.pane.draw();
  }

  set(changes) {
    const before = this.shown;
    Object.assign(this, changes);
    this.label();
    this.render();
    if (before !== this.shown) this.onShown(this.shown);
  }

  get exposure() {
    return this.row.exposure * 2 ** this.stops;
  }

  // Half the width of the colour bar, in steps of 1, 2, 5; relative errors begin at 1.
  get range() {
    const base = this.show === "relative" ? 1 : this.row.range;
    const decade = Math.floor(this.steps / 3);
    const start = 10 ** Math.floor(Math.log10(base) + 1e-6);
    const first = [1, 2, 5].findIndex((s) => Math.abs(base / start - s) < 0.1);
    const at = Math.max(first, 0) + this.steps - 3 * decade;
    return start * [1, 2, 5][at % 3] * 10 ** (decade + Math.floor(at / 3));
  }

  // Everything that the controls say.
  label() {
    const { row, shown } = this;
    const errors = this.show !== "image";
    const check = (group, value) => {
      for (const radio of document.getElementsByName(group)) {
        radio.checked = radio.value === String(value);
        if (radio.checked) bringIntoSight(radio.parentElement);
      }
    };
    check("v-layout", this.layout);
    check("v-show", this.show);
    check("v-method", shown.method);
    const variants = this.ofMethod(shown.method).map((p) =>
      this.chip("v-variant", row.pictures.indexOf(p), p.variant, null, ""));
    const focused = element("v-variants").contains(document.activeElement);
    element("v-variants").replaceChildren(...variants);
    check("v-variant", row.pictures.indexOf(shown));
    if (focused) element("v-variants").querySelector(":checked")?.focus();
    element("v-other").value = row.pictures.indexOf(this.other);
    element("v-reference").value = row.pictures.indexOf(this.reference);
    const hide = (id, hidden) => (element(id).hidden = hidden);
    hide("v-split-label", this.layout !== "split");
    hide("v-canvas", this.layout === "all");
    hide("v-grid", this.layout !== "all");
    hide("v-exposure-label", errors);
    hide("v-range-label", !errors);
    hide("v-colours", !errors);
    element("v-exposure").value = this.stops;
    element("v-exposure-value").textContent = `${this.stops.toFixed(1)} stops, × ${words(this.exposure)}`;
    element("v-range").value = this.steps;
    const unit = this.show === "relative" ? "" : ` ${row.unit}`;
    const range = `${Number(this.range.toPrecision(3))}${unit}`;
    element("v-range-value").textContent = `± ${range}`;
    element("v-low").textContent = `−${range} too dark`;
    element("v-high").textContent = `too bright +${range}`;
    const split = this.layout === "split";
    element("v-left").textContent = split ? this.name(shown) : "";
    element("v-right").textContent = split ? this.name(this.other) : "";
    element("v-reference-name").textContent = this.name(this.reference);
    const facts = [this.name(shown), shown.figures, shown.note].filter(Boolean).join(" · ");
    const line = shown.number
      ? [made("a", { href: `#${shown.id}`, textContent: `#${shown.number}`, className: "table-link" }), ` ${facts}`]
      : [facts];
    element("v-caption").replaceChildren(...line);
    element("v-canvas").setAttribute("aria-label", `${row.title}: ${facts}`);
    const command = document.querySelector(`tr[id="${shown.id}"] code`)?.textContent;
    element("v-again").hidden = !command;
    element("v-command").textContent = command ?? "";
  }

  // A sheet of a picture as it is to be shown.
  async sheet(picture, { row, show, exposure, range, reference }) {
    const rgb = await pixelsOf(picture);
    if (show === "image") return sheet(shownImage(rgb, row.width, row.height, exposure));
    const [truth, mask] = [await pixelsOf(reference), await maskOf(row)];
    const epsilon = show === "relative" ? epsilonOf(truth, mask, this.data.epsilon_fraction) : null;
    const { stops, nothing } = this.data;
    return sheet(errorImage(rgb, truth, mask, row.width, row.height, { epsilon, range, stops, nothing }));
  }

  // Draws; a later call makes an earlier one that still decodes give up.
  async render() {
    const turn = ++this.turn;
    const { row, show, exposure, range, reference, layout } = this;
    const as = { row, show, exposure, range, reference };
    const pictures = layout === "all" ? this.oneOfEach() : layout === "split" ? [this.shown, this.other] : [this.shown];
    const sheets = await Promise.all(pictures.map((p) => this.sheet(p, as)));
    if (turn !== this.turn) return;
    if (layout === "all") this.drawAll(pictures, sheets);
    else this.pane.show(sheets[0], sheets[1] ?? null);
    element("viewer").dataset.drawn = turn;
  }

  // One picture of each method: the shown one, and of the others those most like it.
  oneOfEach() {
    return this.methods().map((m) => (m === this.shown.method ? this.shown : this.nearest(this.shown, m)));
  }

  drawAll(pictures, sheets) {
    const grid = element("v-grid");
    while (grid.children.length > pictures.length) grid.lastChild.remove();
    this.panes ??= [];
    pictures.forEach((picture, i) => {
      if (!grid.children[i]) {
        const canvas = made("canvas");
        const cell = { picture, pane: null };
        cell.pane = new Pane(canvas, this.look, { onPixel: (x, y) => this.read(x, y, cell.picture), onSplit() {} });
        this.panes[i] = cell;
        grid.append(made("figure", {}, [canvas, made("figcaption")]));
      }
      this.panes[i].picture = picture;
      const link = made("a", { href: `#${picture.id}`, textContent: this.name(picture) });
      grid.children[i].lastChild.replaceChildren(link);
      this.panes[i].pane.show(sheets[i], null);
    });
  }

  // The numbers of a pixel.
  async read(x, y, picture) {
    const { row, reference } = this;
    const [rgb, truth, mask] = [await pixelsOf(picture), await pixelsOf(reference), await maskOf(row)];
    const i = y * row.width + x;
    element("v-pixel").textContent = `${x}, ${y}${mask && !mask[i] ? " no surface" : ""}`;
    const lines = element("v-values").tBodies[0].rows;
    for (let c = 0; c < 3; c++) {
      const [e, r] = [rgb[3 * i + c], truth[3 * i + c]];
      [e, r, e - r].forEach((value, line) => (lines[line].cells[c + 1].textContent = words(value)));
    }
  }
}
