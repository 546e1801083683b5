// The page: links that open images, and keys.

const narrow = matchMedia("(max-width: 1099px)");

// Browsers take only so many changes of the address in a time.
const SETTLE_MS = 150;
let settling = 0;

function markShown(picture) {
  for (const node of document.querySelectorAll("[aria-current]")) node.removeAttribute("aria-current");
  for (const node of document.querySelectorAll("tr.shown")) node.classList.remove("shown");
  for (const node of document.querySelectorAll(`main a[href="#${picture.id}"]`)) node.setAttribute("aria-current", "true");
  document.getElementById(picture.id)?.classList.add("shown");
  clearTimeout(settling);
  settling = setTimeout(() => {
    if (location.hash !== `#${picture.id}`) history.replaceState(null, "", `#${picture.id}`);
  }, SETTLE_MS);
}

function openLinked(viewer, event) {
  const link = event.target.closest("a[href^='#']");
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const id = link.getAttribute("href").slice(1);
  if (link.classList.contains("table-link")) {
    event.preventDefault();
    document.getElementById(id)?.scrollIntoView({ block: "center", inline: "start" });
    return;
  }
  const before = location.hash;
  if (!viewer.data.rows.some((row) => row.pictures.some((p) => p.id === id))) return;
  event.preventDefault();
  if (before !== `#${id}`) history.pushState(null, "", `#${id}`);
  viewer.open(id);
  if (narrow.matches) document.getElementById("viewer").scrollIntoView({ block: "start" });
}

function pressed(viewer, event) {
  const typing = event.target.closest("select, textarea, input:not([type=radio])");
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const inRadios = event.target.closest("input[type=radio]");
  const brighten = (by) => (viewer.show === "image" ? { stops: viewer.stops + by / 2 } : { steps: viewer.steps - by });
  const acts = {
    ArrowLeft: () => viewer.flip(-1),
    ArrowRight: () => viewer.flip(1),
    x: () => viewer.swap(),
    l: () => viewer.cycle("layout", ["one", "split", "all"]),
    e: () => viewer.cycle("show", ["image", "signed", "relative"]),
    f: () => viewer.look.set(1, 0.5, 0.5),
    "+": () => viewer.set(brighten(1)),
    "=": () => viewer.set(brighten(1)),
    "-": () => viewer.set(brighten(-1)),
  };
  const method = /^[1-9]$/.test(event.key) ? viewer.methods()[event.key - 1] : null;
  const act = method ? () => viewer.openMethod(method) : acts[event.key];
  if (!act || (inRadios && event.key.startsWith("Arrow"))) return;
  event.preventDefault();
  act();
}

const viewer = new Viewer(JSON.parse(document.getElementById("viewer-data").textContent), markShown);
document.getElementById("viewer").hidden = false;
const first = viewer.data.rows[0].pictures;
if (!viewer.open(location.hash.slice(1))) {
  viewer.beginRow(viewer.data.rows[0]);
  viewer.set({ shown: first[0] });
}
document.addEventListener("click", (event) => openLinked(viewer, event));
document.addEventListener("keydown", (event) => pressed(viewer, event));
for (const name of ["hashchange", "popstate"]) addEventListener(name, () => viewer.open(location.hash.slice(1)));
