// Canvases that share one zoom and one place, and how fingers, mouse and wheel move them.

const MOST_ZOOM = 64;

// What all canvases look at: magnification beyond the fit, and the image's point in the middle, from 0
// to 1 in both directions.
class Look extends EventTarget {
  zoom = 1;
  x = 0.5;
  y = 0.5;

  set(zoom, x, y) {
    this.zoom = Math.min(Math.max(zoom, 1), MOST_ZOOM);
    // What is in sight stays within the image.
    const half = 0.5 / this.zoom;
    this.x = Math.min(Math.max(x, half), 1 - half);
    this.y = Math.min(Math.max(y, half), 1 - half);
    this.dispatchEvent(new Event("change"));
  }
}

// A picture as a canvas of its own size.
function sheet(image) {
  const canvas = document.createElement("canvas");
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

// A canvas that shows one sheet, or two beside a line.
class Pane {
  left = null;
  right = null;
  split = 0.5;

  constructor(canvas, look, { onPixel, onSplit }) {
    this.canvas = canvas;
    this.look = look;
    this.onPixel = onPixel;
    this.onSplit = onSplit;
    this.pointers = new Map();
    this.grip = false;
    new ResizeObserver(() => this.draw()).observe(canvas);
    look.addEventListener("change", () => this.draw());
    canvas.addEventListener("pointerdown", (e) => this.down(e));
    canvas.addEventListener("pointermove", (e) => this.move(e));
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (e) => this.up(e));
    canvas.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
    canvas.addEventListener("dblclick", () => look.set(1, 0.5, 0.5));
  }

  show(left, right) {
    this.left = left;
    this.right = right;
    const shape = `${left.width} / ${left.height}`;
    if (this.canvas.style.aspectRatio !== shape) this.canvas.style.aspectRatio = shape;
    this.draw();
  }

  // Where the image lies, in CSS pixels from the canvas' corner, and the size of one of its pixels.
  placed() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const scale = Math.min(width / this.left.width, height / this.left.height) * this.look.zoom;
    const x = width / 2 - this.look.x * this.left.width * scale;
    const y = height / 2 - this.look.y * this.left.height * scale;
    return { x, y, scale, width, height };
  }

  draw() {
    if (!this.left || !this.canvas.clientWidth) return;
    const { x, y, scale, width, height } = this.placed();
    const density = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.canvas.classList.toggle("zoomed", this.look.zoom > 1);
    const context = this.canvas.getContext("2d");
    context.scale(density, density);
    context.imageSmoothingEnabled = false;
    const line = this.right ? this.split * width : width;
    const part = (from, to, picture) => {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, height);
      context.clip();
      context.drawImage(picture, x, y, picture.width * scale, picture.height * scale);
      context.restore();
    };
    part(0, line, this.left);
    if (!this.right) return;
    part(line, width, this.right);
    context.fillStyle = "#000";
    context.fillRect(line - 2, 0, 4, height);
    context.fillStyle = "#fff";
    context.fillRect(line - 1, 0, 2, height);
  }

  at(event) {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const at = this.at(event);
    this.pointers.set(event.pointerId, at);
    const reach = event.pointerType === "touch" ? 28 : 10;
    const line = this.split * this.canvas.clientWidth;
    this.grip = this.right && this.pointers.size === 1 && Math.abs(at.x - line) < reach;
    this.read(at);
  }

  move(event) {
    const at = this.at(event);
    const before = this.pointers.get(event.pointerId);
    if (before) {
      const others = [...this.pointers].filter(([id]) => id !== event.pointerId);
      this.pointers.set(event.pointerId, at);
      if (others.length > 0) this.pinch(before, at, others[0][1]);
      else if (this.grip) this.onSplit(at.x / this.canvas.clientWidth);
      else this.pan(before, at, 1);
    }
    this.read(at);
  }

  up(event) {
    this.pointers.delete(event.pointerId);
    this.grip = false;
  }

  // Magnifies by a factor and keeps what was at one place of the canvas at another.
  pan(from, to, factor) {
    if (!this.left) return;
    const { x, y, scale, width, height } = this.placed();
    const zoom = Math.min(Math.max(this.look.zoom * factor, 1), MOST_ZOOM);
    const after = (scale * zoom) / this.look.zoom;
    const [w, h] = [this.left.width, this.left.height];
    const [px, py] = [(from.x - x) / scale, (from.y - y) / scale];
    this.look.set(zoom, (px - (to.x - width / 2) / after) / w, (py - (to.y - height / 2) / after) / h);
  }

  pinch(before, at, other) {
    const distance = (p) => Math.hypot(p.x - other.x, p.y - other.y) || 1;
    const middle = (p) => ({ x: (p.x + other.x) / 2, y: (p.y + other.y) / 2 });
    this.pan(middle(before), middle(at), distance(at) / distance(before));
  }

  wheel(event) {
    event.preventDefault();
    const at = this.at(event);
    this.pan(at, at, Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.002)));
  }

  read(at) {
    if (!this.left || !this.onPixel) return;
    const { x, y, scale } = this.placed();
    const [px, py] = [Math.floor((at.x - x) / scale), Math.floor((at.y - y) / scale)];
    if (px < 0 || py < 0 || px >= this.left.width || py >= this.left.height) return;
    this.onPixel(px, py, Boolean(this.right) && at.x > this.split * this.canvas.clientWidth);
  }
}
