// @ts-check
/**
 * Maestra in the browser: makes pages live that also work without it. No dependency, no build;
 * `scripts/check_javascript.sh` checks the types written in the comments.
 *
 * There is no sentence in here: what is said stands in the page, in the reader's language. What
 * comes from the stream is never read as HTML. The server knows everything; what is kept here is
 * only what is on its way there.
 *
 * What pages may use:
 *
 *   form[data-swap]       sent without a reload: the page follows the answer, which is a whole page
 *   form[data-language]   the same, and nothing typed anywhere is lost
 *   form[data-auto]       sent when somebody stops typing or chooses: searches, previews
 *   form[data-draft=URL]  what is typed is also sent there when somebody stops typing;
 *                         [data-draft-saved] inside it is shown once it is kept
 *   [data-live]           for the reader of a template: this changes with the answers. Everything
 *                         follows them, but what is typed stays unless the server says otherwise
 *   [data-board]          a board, see parts/board.html
 *   [data-stream=URL]     the page follows this stream; a page has one
 *   [data-show=...]       sentence, question, lines, face, moves, phase: filled from the stream
 *   [data-hand]           the page moves what the robot is to move
 *   [data-when="a b"]     shown while one of these is so: a phase, view-put-back, question,
 *                         matter-place, speech, lost
 *   button[data-event]    tells the stream this event, a JSON; `answered` gets its question
 *   button[data-replay]   says the last sentence again
 *   [data-refresh=NUMBER] the page shows the stream's state of this number; once there is a later
 *                         one, the page is asked for again, for what only the server can say;
 *                         [data-of] on it tells sessions apart, whose numbers begin anew
 *
 * Sections: values · pages · forms · tokens · the board · fingers and mouse · keyboard · one
 * switch · the stream · what the stream shows · start.
 */

// ---------------------------------------------------------------- values

/** Hands shake: a press that moves less than this is no drag. */
const SLOP_PX = 12;
/** How far beside a cell a token may be dropped, in widths of a cell from its middle. */
const REACH = 0.95;
/** This near the middle of a taken cell, the taken cell is meant and no other. */
const CORE = 0.3;
const GLIDE_MS = 350;
/** How long a token is seen where it should not be, before the robot's hand moves it. */
const HAND_MS = 900;
/** Somebody stopped typing. */
const REST_MS = 500;
const DRAFT_AGAIN_MS = 3000;
/** Several things that happen at once are asked for once. */
const REFRESH_MS = 300;
/** One switch: how long each row or cell is offered, unless the page says otherwise. */
const SCAN_MS = 1500;
/** Then nobody seems to be there; the next press begins anew. */
const SCAN_ROUNDS = 3;
/** Waits between attempts to connect. */
const BACK_OFF_MS = { least: 250, most: 5000 };
/** An event that is not acknowledged by then was sent into a dead connection. */
const ACKNOWLEDGED_WITHIN_MS = 4000;
/** The server says every 10 s that it is there; after so much silence the connection is dead. */
const SILENT_MS = 30_000;
/** Close code of the server: what was followed is over for this page, and a fresh one says why. */
const OVER = 4404;
/** The browser's click after a finger was let go is the same press. */
const SAME_PRESS_MS = 500;
/** This near the edge of a board that is wider than the screen, a carried token moves it. */
const EDGE_PX = 48;

/** @typedef {{label: string, name: string, notes: string[], colour: string, shape: string, picture: string, size: string}} TokenView */
/** @typedef {{number: number, text: string, speech?: string | null}} Said */
/**
 * @typedef {{
 *   type: "state", sequence: number, session?: string, phase: string, connected: boolean,
 *   board?: {rows: number, columns: number, goal_row: number} | null,
 *   cells: Record<string, [number, number]>, held?: string[], tokens: Record<string, TokenView>,
 *   said: Said | null, expression: string, pointed: [number, number][],
 *   view: {view: string, tokens: string[], lines: string[]} | null,
 *   question: {number: number, matter: string, text: string} | null,
 *   language: string, moves?: number, has_board?: boolean, another_round?: boolean,
 *   awaiting?: {number: number, token: string, destination: [number, number]}[],
 * }} State
 */
/** @typedef {{event: string} & Record<string, unknown>} PlayEvent */
/** @typedef {{x: number, y: number}} Point */

/**
 * @template {Element} [T=HTMLElement]
 * @param {string} selector
 * @param {ParentNode} [within]
 * @returns {T[]}
 */
const all = (selector, within = document) =>
  /** @type {T[]} */ ([...within.querySelectorAll(selector)]);

/** @param {string} template @param {Record<string, string>} parts */
const filled = (template, parts) =>
  template.replace(/\{(\w+)\}/g, (gap, name) => parts[name] ?? gap);

const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Have a screen reader say `text`. @param {string} text */
function announce(text) {
  const line = document.getElementById("announcer");
  if (!line) return;
  // The same words once more are only said if they were gone for a moment.
  line.textContent = "";
  setTimeout(() => (line.textContent = text), 50);
}

/** @param {HTMLFormElement} form @param {HTMLElement | null} [submitter] */
function fieldsOf(form, submitter = null) {
  const fields = new FormData(form);
  if (submitter instanceof HTMLButtonElement && submitter.name) {
    fields.append(submitter.name, submitter.value);
  }
  return fields;
}

/** Without files, as a form sends them by itself. @param {FormData} fields */
function encoded(fields) {
  const pairs = new URLSearchParams();
  for (const [name, value] of fields) if (typeof value === "string") pairs.append(name, value);
  return pairs;
}

// ---------------------------------------------------------------- pages

/**
 * Which of two trees an element is the same in: by its id, or for fields and forms by what they
 * are called.
 * @param {Node} node
 */
function keyOf(node) {
  if (!(node instanceof Element)) return "";
  if (node.id) return `#${node.id}`;
  if (node instanceof HTMLFormElement) return `form ${node.getAttribute("action")}`;
  const name = node.getAttribute("name");
  const value = node.matches("[type=checkbox], [type=radio], button") && node.getAttribute("value");
  return name ? `${node.nodeName} ${name} ${value || ""}` : "";
}

/** What the page says that a field holds. @param {Element} field */
function saidOf(field) {
  if (field instanceof HTMLSelectElement) {
    return JSON.stringify([...field.options].map((option) => option.defaultSelected));
  }
  if (field instanceof HTMLTextAreaElement) return field.defaultValue;
  return field instanceof HTMLInputElement ? `${field.defaultValue} ${field.defaultChecked}` : "";
}

/** Give a field what the page says. @param {Element} field */
function obey(field) {
  if (field instanceof HTMLInputElement) {
    if (field.type === "checkbox" || field.type === "radio") field.checked = field.defaultChecked;
    else if (field.type === "file") field.value = "";
    else if (field.type !== "hidden") field.value = field.defaultValue;
  } else if (field instanceof HTMLTextAreaElement) {
    field.value = field.defaultValue;
  } else if (field instanceof HTMLSelectElement) {
    const chosen = [...field.options].findIndex((option) => option.defaultSelected);
    field.selectedIndex = Math.max(chosen, 0);
  }
}

/**
 * Turns the page into another one and keeps what is the same: what is typed, where the reader is,
 * what is opened.
 */
class Morph {
  /**
   * @param {(field: Element, isNew: boolean) => boolean} follows whether a field takes what the
   *     page says, which may be new
   */
  constructor(follows) {
    this.follows = follows;
  }

  /** @param {Element} old @param {Element} fresh */
  element(old, fresh) {
    // What is being read aloud is the browser's.
    if (old.id === "announcer") return;
    const said = saidOf(old);
    for (const { name } of [...old.attributes]) {
      // Whether a reader has opened something is the reader's.
      const own = name === "open" && old instanceof HTMLDetailsElement;
      if (!fresh.hasAttribute(name) && !own) old.removeAttribute(name);
    }
    for (const { name, value } of fresh.attributes) {
      if (old.getAttribute(name) !== value) old.setAttribute(name, value);
    }
    this.children(old, fresh);
    const isField = old.matches("input, textarea, select");
    if (isField && this.follows(old, said !== saidOf(old))) obey(old);
  }

  /** @param {Element} old @param {Element} fresh */
  children(old, fresh) {
    /** @type {Map<string, Node[]>} */
    const keyed = new Map();
    const plain = new Set();
    for (const child of old.childNodes) {
      const key = keyOf(child);
      if (key) keyed.set(key, [...(keyed.get(key) ?? []), child]);
      else plain.add(child);
    }
    let place = old.firstChild;
    for (const wanted of fresh.childNodes) {
      const key = keyOf(wanted);
      const match = key
        ? keyed.get(key)?.shift()
        : [...plain].find((node) => node.nodeName === wanted.nodeName);
      plain.delete(match);
      if (match && match.nodeName === wanted.nodeName) {
        if (match === place) place = match.nextSibling;
        else old.insertBefore(match, place);
        if (match instanceof Element) this.element(match, /** @type {Element} */ (wanted));
        else if (match.nodeValue !== wanted.nodeValue) match.nodeValue = wanted.nodeValue;
      } else {
        old.insertBefore(document.importNode(wanted, true), place);
      }
    }
    for (const left of [...plain, ...[...keyed.values()].flat()]) left.parentNode?.removeChild(left);
  }
}

/** Where each token of each board is now. */
function places() {
  /** @type {Map<string, DOMRect>} */
  const found = new Map();
  for (const board of all("[data-board]")) {
    for (const token of all("[data-token]", board)) {
      found.set(`${board.id} ${token.dataset["token"]}`, token.getBoundingClientRect());
    }
  }
  return found;
}

/** Have every token that moved since glide to where it is now. @param {Map<string, DOMRect>} before */
function glide(before) {
  if (isStill()) return;
  for (const board of all("[data-board]")) {
    for (const token of all("[data-token]", board)) {
      const from = before.get(`${board.id} ${token.dataset["token"]}`);
      const cell = token.parentElement;
      if (!from || !cell) continue;
      const to = token.getBoundingClientRect();
      const [x, y] = [from.left - to.left, from.top - to.top];
      if (Math.hypot(x, y) < 2) continue;
      const moving = token.animate(
        [{ transform: `translate(${x}px, ${y}px)` }, { transform: "none" }],
        { duration: GLIDE_MS, easing: "ease-in-out" },
      );
      // Its cell comes before others on the page, and would be under them.
      cell.classList.add("gliding");
      const ended = () => cell.classList.remove("gliding");
      moving.addEventListener("finish", ended);
      moving.addEventListener("cancel", ended);
    }
  }
}

/** The page that is shown; the address bar may be a step ahead, when somebody goes back. */
let shownPath = location.pathname;

/**
 * Show a page that was fetched; throws if it is none.
 * @param {Response} answer
 * @param {Map<Element, string>} sent fields of the form that was sent, as they were
 * @param {boolean} keeps whether all that is typed stays, also in the form that was sent
 */
async function show(answer, sent, keeps = false) {
  const isPage = answer.headers.get("content-type")?.startsWith("text/html");
  if (answer.status >= 500 || !isPage) throw new Error(`${answer.status} for ${answer.url}`);
  const fresh = new DOMParser().parseFromString(await answer.text(), "text/html");
  await Board.allFree();
  // With more on its way this is no longer how things are.
  if (sending.waiting) return;
  if (isOlder(fresh)) return;
  const address = new URL(answer.url);
  // What is refused has the address of what was asked for, and that is no page.
  const moves = answer.ok && address.href !== location.href;
  const elsewhere = answer.ok && address.pathname !== shownPath;
  if (answer.ok) shownPath = address.pathname;
  if (moves) history[elsewhere ? "pushState" : "replaceState"](null, "", address);
  const before = places();
  const focused = document.activeElement;
  document.title = fresh.title;
  document.documentElement.lang = fresh.documentElement.lang;
  if (elsewhere) {
    document.body.replaceChildren();
  }
  /** @param {Element} field @param {boolean} isNew */
  const follows = (field, isNew) => {
    if (keeps) return false;
    if (!sent.has(field)) return isNew && field !== focused;
    // What was typed since it was sent is not in the answer.
    return /** @type {HTMLInputElement} */ (field).value === sent.get(field);
  };
  new Morph(follows).element(document.body, fresh.body);
  start();
  glide(before);
  if (elsewhere) scrollTo(0, 0);
  refocus(focused);
}

/** Whether the page that is there shows a later state of the same session. @param {Document} fresh */
function isOlder(fresh) {
  const [now] = all("[data-refresh]");
  const [then] = all("[data-refresh]", fresh);
  if (!now || !then || now.dataset["of"] !== then.dataset["of"]) return false;
  return Number(then.dataset["refresh"]) < Number(now.dataset["refresh"]);
}

/** Keep the focus, or put it where the reader goes on. @param {Element | null} focused */
function refocus(focused) {
  const wanted = document.querySelector("[autofocus], [aria-invalid=true]") ?? focused;
  if (wanted instanceof HTMLElement && wanted.isConnected && wanted !== document.body) {
    if (wanted !== document.activeElement) wanted.focus({ preventScroll: wanted === focused });
  } else if (document.activeElement === document.body && focused !== document.body) {
    document.getElementById("main")?.focus({ preventScroll: true });
  }
}

/** Show the page of this address as it is now. @param {string} url */
async function visit(url) {
  try {
    await show(await fetch(url, { headers: { Accept: "text/html" } }), new Map(), true);
  } catch {
    // No connection: the page stays as it is, and the stream comes back by itself.
  }
}

// ---------------------------------------------------------------- forms

/** Forms are sent one after the other, for each answer is a whole page. */
const sending = {
  /** @type {Promise<void>} */
  last: Promise.resolve(),
  waiting: 0,
  /** @type {Set<HTMLFormElement>} */
  busy: new Set(),
};

/**
 * Send a form and follow the answer.
 * @param {HTMLFormElement} form
 * @param {FormData} fields
 */
function send(form, fields) {
  const sent = new Map(
    [...form.elements].map((field) => [field, /** @type {HTMLInputElement} */ (field).value]),
  );
  const action = form.getAttribute("action") || location.href;
  const url = new URL(action, location.href);
  const gets = form.method.toLowerCase() === "get";
  if (gets) url.search = encoded(fields).toString();
  const hasFiles = form.enctype === "multipart/form-data";
  const body = gets ? null : hasFiles ? fields : encoded(fields);
  const method = gets ? "GET" : "POST";
  sending.waiting += 1;
  sending.last = sending.last.then(async () => {
    const unsent = document.getElementById("unsent");
    try {
      const answer = await fetch(url, { method, body, headers: { Accept: "text/html" } });
      if (unsent) unsent.hidden = true;
      sending.waiting -= 1;
      await show(answer, sent, "language" in form.dataset);
    } catch {
      sending.waiting -= 1;
      if (unsent) unsent.hidden = false;
      for (const board of all("[data-board]")) boards.get(board)?.undo();
    }
  });
  return sending.last;
}

document.addEventListener("submit", (event) => {
  const form = event.target;
  if (!(form instanceof HTMLFormElement) || event.defaultPrevented) return;
  if (!form.matches("[data-swap], [data-language]")) return;
  event.preventDefault();
  // Pressed twice by a shaking hand, it is sent once.
  if (sending.busy.has(form)) return;
  sending.busy.add(form);
  const fields = fieldsOf(form, event.submitter);
  const speaks = form.matches("[data-language]");
  if (speaks) fields.set("back", location.pathname + location.search);
  // What waits to be kept would come after what is sent now, and is older.
  drafts.forget(form);
  const ready = speaks ? drafts.flush() : Promise.resolve();
  void ready.then(() => send(form, fields)).finally(() => sending.busy.delete(form));
});

addEventListener("popstate", () => void visit(location.href));

/** What is typed is kept as it is typed. */
class Drafts {
  constructor() {
    /** @type {Map<HTMLFormElement, number>} */
    this.waiting = new Map();
    document.addEventListener("input", (event) => {
      const form = event.target instanceof Element && event.target.closest("form");
      if (form && form.dataset["draft"]) this.later(form, REST_MS);
    });
    addEventListener("pagehide", () => void this.flush());
  }

  /** @param {HTMLFormElement} form @param {number} wait */
  later(form, wait) {
    clearTimeout(this.waiting.get(form));
    for (const line of all("[data-draft-saved]", form)) line.hidden = true;
    this.waiting.set(form, setTimeout(() => void this.keep(form), wait));
  }

  /** @param {HTMLFormElement} form */
  async keep(form) {
    clearTimeout(this.waiting.get(form));
    this.waiting.delete(form);
    try {
      const body = encoded(new FormData(form));
      // Also when the page is being left.
      const answer = await fetch(form.dataset["draft"] ?? "", { method: "POST", body, keepalive: true });
      if (answer.status >= 500) throw new Error(answer.statusText);
      for (const line of all("[data-draft-saved]", form)) line.hidden = !answer.ok;
    } catch {
      if (!this.waiting.has(form)) this.later(form, DRAFT_AGAIN_MS);
    }
  }

  /** It is sent as a whole. @param {HTMLFormElement} form */
  forget(form) {
    clearTimeout(this.waiting.get(form));
    this.waiting.delete(form);
  }

  /** Keep now what waits. */
  async flush() {
    await Promise.all([...this.waiting.keys()].map((form) => this.keep(form)));
  }
}

const drafts = new Drafts();

/** Sent when somebody stops typing: searches and previews. @type {WeakMap<HTMLFormElement, number>} */
const resting = new WeakMap();
document.addEventListener("input", (event) => {
  const form = event.target instanceof Element && event.target.closest("form");
  if (!form || !("auto" in form.dataset)) return;
  clearTimeout(resting.get(form));
  resting.set(form, setTimeout(() => void send(form, fieldsOf(form)), REST_MS));
});

// ---------------------------------------------------------------- tokens

/** The same as parts/token.html makes. @param {HTMLElement} token @param {TokenView} view */
function drawToken(token, view) {
  const drawn = JSON.stringify(view);
  if (token.dataset["drawn"] === drawn) return;
  token.className = "token";
  for (const name of ["colour", "shape", "size", "name"]) {
    const value = /** @type {Record<string, unknown>} */ (view)[name];
    if (value) token.dataset[name] = String(value);
    else delete token.dataset[name];
  }
  token.toggleAttribute("data-picture", Boolean(view.picture));
  token.replaceChildren();
  if (view.picture) {
    const picture = document.createElement("img");
    Object.assign(picture, { src: view.picture, alt: "", draggable: false });
    token.append(picture);
  }
  const texts = [["label", view.label], ...view.notes.map((note) => ["note", note])];
  for (const [kind, text] of texts) {
    if (!text || !kind) continue;
    const line = document.createElement("span");
    line.className = kind;
    line.textContent = text;
    token.append(line);
  }
  token.dataset["drawn"] = drawn;
}

// ---------------------------------------------------------------- the board

/** @type {WeakMap<Element, Board>} */
const boards = new WeakMap();

/** One board of the page: what lies where, what is in the hand, and what moves tell. */
class Board {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    /** @type {Drag | null} */
    this.drag = null;
    /** Whoever waits until nothing is carried. @type {(() => void)[]} */
    this.waiting = [];
    /** When a finger or the mouse was last let go. */
    this.heard = -Infinity;
    if (root instanceof HTMLFormElement) {
      root.addEventListener("submit", (event) => event.preventDefault());
      root.addEventListener("click", (event) => this.clicked(event));
      root.addEventListener("pointerdown", (event) => this.touched(event));
      root.addEventListener("keydown", (event) => this.typed(event));
      root.addEventListener("focusin", (event) => this.focused(event));
    }
  }

  /** When no token is being carried on any board. */
  static async allFree() {
    await Promise.all(
      all("[data-board]").map((root) => {
        const board = boards.get(root);
        return board?.drag && new Promise((resolve) => board.waiting.push(() => resolve(null)));
      }),
    );
  }

  /** After the page has changed. */
  refresh() {
    const cells = this.cells();
    if (!(this.root instanceof HTMLFormElement) || !cells.length) return;
    // One cell is in the order of the Tab key; arrows reach the others.
    const last = cells.find((cell) => cell.value === this.root.dataset["at"]);
    const current = cells.find((cell) => cell === document.activeElement) ?? last ?? cells[0];
    for (const cell of cells) cell.tabIndex = cell === current ? 0 : -1;
  }

  /** @returns {HTMLButtonElement[]} */
  cells() {
    return all(".cell", this.root);
  }

  /** @returns {HTMLButtonElement[][]} */
  rows() {
    return all(".row", this.root).map((row) => all(".cell", row));
  }

  /** @param {number} row @param {number} column */
  at(row, column) {
    return this.rows()[row - 1]?.[column - 1] ?? null;
  }

  /** Row and column, from 1. @param {Element} cell @returns {[number, number]} */
  placeOf(cell) {
    const rows = this.rows();
    const row = rows.findIndex((one) => one.includes(/** @type {HTMLButtonElement} */ (cell)));
    const column = rows[row]?.indexOf(/** @type {HTMLButtonElement} */ (cell)) ?? -1;
    return [row + 1, column + 1];
  }

  /** @param {Element | null} cell @returns {HTMLElement | null} */
  tokenOn(cell) {
    return cell?.querySelector("[data-token]") ?? null;
  }

  /** @param {string} id @returns {HTMLElement | null} */
  token(id) {
    return this.root.querySelector(`[data-token="${CSS.escape(id)}"]`);
  }

  /** The token in the hand, as on the server. */
  get held() {
    const id = this.root.dataset["held"];
    return id === undefined ? null : this.token(id);
  }

  /** @param {HTMLElement | null} token */
  hold(token) {
    for (const cell of this.cells()) {
      cell.toggleAttribute("data-held", token !== null && cell.contains(token));
      cell.classList.remove("over");
    }
    if (token) this.root.dataset["held"] = token.dataset["token"];
    else delete this.root.dataset["held"];
    this.name();
  }

  /** Give each cell its name again. */
  name() {
    const texts = this.root.dataset;
    this.rows().forEach((row, r) =>
      row.forEach((cell, c) => {
        const token = this.tokenOn(cell);
        const isHeld = cell.hasAttribute("data-held");
        const text = token ? texts[isHeld ? "nameHeld" : "nameToken"] : texts["nameEmpty"];
        const parts = { row: `${r + 1}`, column: `${c + 1}`, token: token?.dataset["name"] ?? "" };
        const marks = ["pointed", "wrong", "allowed"]
          .filter((mark) => cell.hasAttribute(`data-${mark}`))
          .map((mark) => texts[`name${mark[0]?.toUpperCase()}${mark.slice(1)}`] ?? "");
        const name = [filled(text ?? "", parts), ...marks].join(", ");
        if (text && cell.getAttribute("aria-label") !== name) cell.setAttribute("aria-label", name);
      }),
    );
  }

  /** @param {"held" | "moved" | "released" | "taken"} what @param {HTMLElement | null} token */
  say(what, token) {
    const text = this.root.dataset[`say${what[0]?.toUpperCase()}${what.slice(1)}`] ?? "";
    const [row, column] = token?.parentElement ? this.placeOf(token.parentElement) : [0, 0];
    const parts = { token: token?.dataset["name"] ?? "", row: `${row}`, column: `${column}` };
    announce(filled(text, parts));
  }

  /**
   * A cell is pressed: the first press takes a token up, the second puts it down.
   * @param {HTMLButtonElement} cell
   */
  press(cell) {
    const held = this.held;
    const there = this.tokenOn(cell);
    if (held && there === held) this.release(cell);
    else if (held && !there) this.move(held, cell);
    else if (there) {
      if (held && stream) stream.tell({ event: "put-back", token: held.dataset["token"] });
      this.lift(there, cell);
    }
  }

  /** @param {HTMLElement} token @param {HTMLButtonElement} cell where it lies */
  lift(token, cell) {
    this.hold(token);
    this.say("held", token);
    this.post({ event: "lifted", token: token.dataset["token"] }, { cell: cell.value });
  }

  /** @param {HTMLButtonElement} cell where the held token lies */
  release(cell) {
    const held = this.held;
    this.hold(null);
    this.say("released", held);
    this.post({ event: "put-back", token: held?.dataset["token"] }, { cell: cell.value });
  }

  /**
   * Show the move at once, and tell it.
   * @param {HTMLElement} token
   * @param {HTMLButtonElement} cell
   * @param {DOMRect | null} from where the token was let go, if it was carried
   */
  move(token, cell, from = null) {
    const id = token.dataset["token"] ?? "";
    const before = places();
    if (from) before.set(`${this.root.id} ${id}`, from);
    cell.append(token);
    this.hold(null);
    this.say("moved", token);
    glide(before);
    this.post(
      { event: "placed", token: id, cell: this.placeOf(cell) },
      { token: id, cell: cell.value },
    );
  }

  /**
   * Tell the stream, or else the page's server.
   * @param {PlayEvent} event
   * @param {Record<string, string>} fields
   */
  post(event, fields) {
    if (stream && this.root.dataset["stream"]) {
      stream.tell(event);
    } else if (this.root instanceof HTMLFormElement) {
      const all = new FormData(this.root);
      for (const [name, value] of Object.entries(fields)) all.set(name, value);
      void send(this.root, all);
    }
  }

  /** What was shown at once did not come to pass. */
  undo() {
    if (stream?.state) this.follow(stream.state);
    else void visit(location.href);
  }

  /** Show what the stream says. @param {State} state */
  follow(state) {
    for (const token of all("[data-token]", this.root)) {
      if (!((token.dataset["token"] ?? "") in state.cells)) token.remove();
    }
    for (const [id, [row, column]] of Object.entries(state.cells)) {
      const cell = this.at(row, column);
      const view = state.tokens[id];
      if (!cell || !view) continue;
      const token = this.token(id) ?? document.createElement("span");
      token.dataset["token"] = id;
      drawToken(token, view);
      if (token.parentElement !== cell) cell.append(token);
    }
    const pointed = new Set(state.pointed.map(([row, column]) => this.at(row, column)));
    for (const cell of this.cells()) cell.toggleAttribute("data-pointed", pointed.has(cell));
    const held = state.held?.at(-1);
    if (!this.drag) this.hold(held === undefined ? null : this.token(held));
  }

  // ------------------------------------------------------------ fingers and mouse

  /**
   * The cell that is meant by a press at a point: also one that is missed by a little.
   * @param {Point} point
   */
  near(point) {
    const away = (/** @type {Element} */ cell) => {
      const box = cell.getBoundingClientRect();
      const x = Math.max(box.left - point.x, 0, point.x - box.right);
      const y = Math.max(box.top - point.y, 0, point.y - box.bottom);
      return Math.hypot(x, y);
    };
    const [nearest] = this.cells().sort((one, other) => away(one) - away(other));
    return nearest && away(nearest) <= SLOP_PX ? nearest : null;
  }

  /**
   * Where a token goes that is let go with its middle at `point`: onto the nearest cell that is
   * free, if one is near; null if it goes back.
   * @param {Point} point
   * @param {HTMLElement} token
   */
  target(point, token) {
    const ranked = this.cells()
      .map((cell) => {
        const box = cell.getBoundingClientRect();
        const [x, y] = [box.left + box.width / 2 - point.x, box.top + box.height / 2 - point.y];
        return { cell, away: Math.hypot(x, y) / Math.max(box.width, 1) };
      })
      .sort((one, other) => one.away - other.away);
    const isTaken = (/** @type {Element} */ cell) => {
      const there = this.tokenOn(cell);
      return there !== null && there !== token;
    };
    const first = ranked[0];
    if (!first || (isTaken(first.cell) && first.away < CORE)) return null;
    const free = ranked.find(({ cell }) => !isTaken(cell));
    return free && free.away <= REACH ? free.cell : null;
  }

  /** @param {PointerEvent} event */
  touched(event) {
    // A second finger, a palm, another button: not meant.
    if (this.drag || (event.pointerType === "mouse" && event.button !== 0)) return;
    const cell = this.near({ x: event.clientX, y: event.clientY });
    if (cell && !("scan" in this.root.dataset)) this.drag = new Drag(this, cell, event);
  }

  /** Nothing is carried any more. */
  dropped() {
    this.drag = null;
    this.heard = performance.now();
    for (const done of this.waiting.splice(0)) done();
  }

  // ------------------------------------------------------------ keyboard and screen readers

  /**
   * Enter, Space, and what screen readers press. A finger or mouse was heard by `Drag` already.
   * @param {MouseEvent} event
   */
  clicked(event) {
    event.preventDefault();
    const cell = event.target instanceof Element ? event.target.closest("button.cell") : null;
    if (!(cell instanceof HTMLButtonElement)) return;
    const isHeard = event.detail > 0 && performance.now() - this.heard < SAME_PRESS_MS;
    if (!isHeard) this.press(cell);
  }

  /** @param {FocusEvent} event */
  focused(event) {
    const cell = event.target;
    if (!(cell instanceof HTMLButtonElement)) return;
    this.root.dataset["at"] = cell.value;
    for (const one of this.cells()) one.tabIndex = one === cell ? 0 : -1;
  }

  /** @param {KeyboardEvent} event */
  typed(event) {
    const cell = event.target instanceof Element && event.target.closest(".cell");
    if (!cell || event.altKey || event.ctrlKey || event.metaKey) return;
    const [row, column] = this.placeOf(cell);
    const width = this.rows()[row - 1]?.length ?? 0;
    /** @type {Record<string, [number, number]>} */
    const ways = {
      ArrowUp: [row - 1, column],
      ArrowDown: [row + 1, column],
      ArrowLeft: [row, column - 1],
      ArrowRight: [row, column + 1],
      Home: [row, 1],
      End: [row, width],
    };
    const way = ways[event.key];
    if (way) {
      event.preventDefault();
      this.at(...way)?.focus();
    } else if (event.key === "Escape") {
      const from = this.held?.parentElement;
      if (from instanceof HTMLButtonElement && !this.drag) this.release(from);
    }
  }
}

/** One press of a finger or the mouse: a tap, or once it has moved far enough, a drag. */
class Drag {
  /**
   * @param {Board} board
   * @param {HTMLButtonElement} cell
   * @param {PointerEvent} event
   */
  constructor(board, cell, event) {
    this.board = board;
    this.cell = cell;
    this.pointer = event.pointerId;
    this.begun = { x: event.clientX, y: event.clientY };
    this.now = this.begun;
    this.token = board.tokenOn(cell);
    /** What follows the finger. @type {HTMLElement | null} */
    this.carried = null;
    this.listening = new AbortController();
    const { signal } = this.listening;
    addEventListener("pointermove", (moved) => this.moved(moved), { signal });
    addEventListener("pointerup", (up) => up.pointerId === this.pointer && this.let(), { signal });
    addEventListener("pointercancel", (up) => up.pointerId === this.pointer && this.cancel(), { signal });
    addEventListener("blur", () => this.cancel(), { signal });
    addEventListener("keydown", (key) => key.key === "Escape" && this.cancel(), { signal });
    // Else the browser drags pictures by itself, and a long press opens a menu.
    for (const own of ["dragstart", "contextmenu"]) {
      addEventListener(own, (begun) => begun.preventDefault(), { signal });
    }
  }

  /** @param {PointerEvent} event */
  moved(event) {
    if (event.pointerId !== this.pointer) return;
    this.now = { x: event.clientX, y: event.clientY };
    const far = Math.hypot(this.now.x - this.begun.x, this.now.y - this.begun.y);
    if (!this.carried && this.token && far > SLOP_PX) this.lift(this.token);
    this.follow();
  }

  /** @param {HTMLElement} token */
  lift(token) {
    const box = token.getBoundingClientRect();
    const carried = /** @type {HTMLElement} */ (token.cloneNode(true));
    delete carried.dataset["token"];
    carried.classList.add("carried");
    carried.setAttribute("aria-hidden", "true");
    Object.assign(carried.style, { width: `${box.width}px`, height: `${box.height}px` });
    this.corner = { x: box.left, y: box.top };
    // Texts go by the width of a cell, so it has to be in one.
    this.holder = document.createElement("span");
    this.holder.className = "carrier";
    Object.assign(this.holder.style, { width: `${this.cell.clientWidth}px` });
    this.holder.append(carried);
    document.body.append(this.holder);
    this.carried = carried;
    this.cell.classList.add("lifted");
    const held = this.board.held;
    if (stream && this.board.root.dataset["stream"]) {
      if (held && held !== token) stream.tell({ event: "put-back", token: held.dataset["token"] });
      if (held !== token) stream.tell({ event: "lifted", token: token.dataset["token"] });
    }
    this.board.hold(null);
    this.scrolling = setInterval(() => this.scroll(), 16);
  }

  /** The middle of what is carried. @returns {Point} */
  middle() {
    const box = (this.carried ?? this.cell).getBoundingClientRect();
    return { x: box.left + box.width / 2, y: box.top + box.height / 2 };
  }

  follow() {
    if (!this.carried || !this.corner || !this.token) return;
    const x = this.corner.x + this.now.x - this.begun.x;
    const y = this.corner.y + this.now.y - this.begun.y;
    this.carried.style.transform = `translate(${x}px, ${y}px)`;
    const target = this.board.target(this.middle(), this.token);
    for (const cell of this.board.cells()) cell.classList.toggle("over", cell === target);
  }

  /** A board that is wider than the screen comes along. */
  scroll() {
    const rows = this.board.root.querySelector(".rows");
    if (!rows || rows.scrollWidth <= rows.clientWidth) return;
    const box = rows.getBoundingClientRect();
    const right = Math.min(box.right, innerWidth);
    const left = Math.max(box.left, 0);
    if (this.now.x > right - EDGE_PX) rows.scrollLeft += 6;
    else if (this.now.x < left + EDGE_PX) rows.scrollLeft -= 6;
    else return;
    this.follow();
  }

  /** The finger is lifted. */
  let() {
    const { board, token, carried } = this;
    if (!carried || !token) {
      this.end();
      this.cell.focus({ preventScroll: true });
      board.press(this.cell);
      return;
    }
    const target = board.target(this.middle(), token);
    if (!target || target === this.cell) {
      board.say(target ? "released" : "taken", token);
      this.cancel();
      return;
    }
    const from = carried.getBoundingClientRect();
    this.end();
    board.move(token, target, from);
  }

  /** The token stays where it was. */
  cancel() {
    const { board, token, carried } = this;
    if (!carried || !token) {
      this.end();
      return;
    }
    const before = places();
    before.set(`${board.root.id} ${token.dataset["token"]}`, carried.getBoundingClientRect());
    this.end();
    glide(before);
    if (stream && board.root.dataset["stream"]) {
      stream.tell({ event: "put-back", token: token.dataset["token"] });
    }
  }

  end() {
    this.listening.abort();
    clearInterval(this.scrolling);
    this.holder?.remove();
    this.cell.classList.remove("lifted");
    for (const cell of this.board.cells()) cell.classList.remove("over");
    this.board.dropped();
  }
}

// ---------------------------------------------------------------- one switch

/**
 * One key, or a touch anywhere: rows are offered one after the other, then the cells of the row
 * that was chosen. The page's controls are offered after the rows.
 */
class Scanner {
  constructor() {
    /** What is offered now: rows, or the cells of one. @type {HTMLElement[]} */
    this.offered = [];
    this.place = 0;
    this.rounds = 0;
    /** @type {number | undefined} */
    this.timer = undefined;
    addEventListener("keydown", (event) => this.typed(event), { capture: true });
    addEventListener("pointerdown", (event) => this.touched(event), { capture: true });
    /** Until when a click belongs to a press that was heard. */
    this.swallow = 0;
    const click = (/** @type {MouseEvent} */ event) => {
      if (event.detail === 0 || performance.now() > this.swallow) return;
      event.preventDefault();
      event.stopPropagation();
    };
    addEventListener("click", click, { capture: true });
  }

  /** The board of the page that is used with one switch, if there is one. */
  get board() {
    const root = document.querySelector("[data-board][data-scan]");
    return root ? (boards.get(root) ?? null) : null;
  }

  /** @param {KeyboardEvent} event */
  typed(event) {
    const field = event.target instanceof Element && event.target.matches("input, select, textarea");
    if (!this.board || field || event.repeat || (event.key !== " " && event.key !== "Enter")) return;
    // A control that was reached by other keys is pressed as ever.
    const own = event.target instanceof Element && event.target.closest("a, button:not(.cell)");
    if (own && !this.offered.length) return;
    event.preventDefault();
    event.stopPropagation();
    this.press();
  }

  /** @param {PointerEvent} event */
  touched(event) {
    const control = event.target instanceof Element && event.target.closest("a, button:not(.cell)");
    if (!this.board || (control && !this.offered.length)) return;
    event.preventDefault();
    event.stopPropagation();
    // The click that follows is the same press.
    this.swallow = performance.now() + SAME_PRESS_MS;
    this.press();
  }

  press() {
    const { board } = this;
    const chosen = this.offered[this.place];
    if (!board) return;
    if (!chosen) {
      this.offer(this.groups());
    } else if (chosen instanceof HTMLButtonElement || chosen instanceof HTMLAnchorElement) {
      this.stop();
      if (chosen instanceof HTMLButtonElement && chosen.matches(".cell")) board.press(chosen);
      else chosen.click();
      // What was taken up has to be put down: go on by itself.
      if (board.held) this.offer(this.groups());
    } else {
      const items = this.items(chosen);
      if (items.length === 1 && items[0]) {
        this.offered = items;
        this.place = 0;
        this.press();
      } else {
        this.offer(items);
      }
    }
  }

  /** Rows with something to choose, and the page's controls. */
  groups() {
    return [...all("[data-scan] .row"), ...all("main .controls")].filter(
      (group) => this.items(group).length,
    );
  }

  /** @param {HTMLElement} group @returns {HTMLElement[]} */
  items(group) {
    const { board } = this;
    const held = board?.held;
    const cells = all(".cell", group);
    if (!board || !cells.length) {
      return all("a, button:not(:disabled)", group).filter((one) => one.checkVisibility());
    }
    return cells.filter((cell) => {
      const there = board.tokenOn(cell);
      return held ? !there || there === held : there;
    });
  }

  /** @param {HTMLElement[]} offered */
  offer(offered) {
    this.stop();
    this.offered = offered;
    this.rounds = 0;
    this.mark(0);
    const wait = Number(this.board?.root.dataset["scan"]) || SCAN_MS;
    this.timer = setInterval(() => {
      const next = (this.place + 1) % this.offered.length;
      this.rounds += next === 0 ? 1 : 0;
      if (this.rounds >= SCAN_ROUNDS) this.stop();
      else this.mark(next);
    }, wait);
  }

  /** @param {number} place */
  mark(place) {
    this.place = place;
    for (const one of all(".scanned")) one.classList.remove("scanned");
    const now = this.offered[place];
    now?.classList.add("scanned");
    now?.scrollIntoView({ block: "nearest", inline: "nearest" });
    const name = now?.getAttribute("aria-label") ?? now?.textContent?.trim();
    if (name) announce(name);
  }

  stop() {
    clearInterval(this.timer);
    this.offered = [];
    this.place = 0;
    for (const one of all(".scanned")) one.classList.remove("scanned");
  }
}

void new Scanner();

// ---------------------------------------------------------------- the stream

/** What happens in a room: comes back after every cut, and tells everything exactly once. */
class Stream {
  /** @param {string} path @param {(state: State) => void} shows @param {() => void} fails */
  constructor(path, shows, fails) {
    this.path = path;
    this.shows = shows;
    this.fails = fails;
    /** The newest. @type {State | null} */
    this.state = null;
    /** Events on their way, by their ids; the server takes the same id once. @type {Map<string, {event: PlayEvent, sent: number}>} */
    this.outbox = new Map();
    this.wait = BACK_OFF_MS.least;
    /** When the server was heard last. */
    this.heard = 0;
    /** @type {WebSocket | null} */
    this.socket = null;
    /** @type {number | undefined} */
    this.again = undefined;
    this.closed = new AbortController();
    const { signal } = this.closed;
    for (const name of ["online", "pageshow", "focus"]) {
      addEventListener(name, () => this.hurry(), { signal });
    }
    this.watching = setInterval(() => this.watch(), 1000);
    this.connect();
  }

  connect() {
    clearTimeout(this.again);
    const url = new URL(this.path, location.href);
    url.protocol = url.protocol.replace("http", "ws");
    const socket = new WebSocket(url);
    this.socket = socket;
    let newest = -1;
    socket.addEventListener("open", () => {
      this.wait = BACK_OFF_MS.least;
      this.heard = performance.now();
      for (const id of this.outbox.keys()) this.sendOne(id);
    });
    socket.addEventListener("message", ({ data }) => {
      const message = JSON.parse(data);
      this.heard = performance.now();
      if (message.type === "state" && message.sequence >= newest) {
        newest = message.sequence;
        this.state = message;
        document.documentElement.removeAttribute("data-lost");
        this.shows(message);
      } else if (message.type === "ack") {
        this.outbox.delete(message.id);
      } else if (message.type === "fault" && !message.again) {
        this.outbox.delete(message.id);
        this.fails();
      }
    });
    socket.addEventListener("close", ({ code }) => {
      if (this.socket !== socket) return;
      this.later();
      if (code === OVER) void visit(location.href);
    });
  }

  /** Try again after a while; nobody is told, for nothing is lost. */
  later() {
    this.socket = null;
    document.documentElement.setAttribute("data-lost", "");
    if (this.closed.signal.aborted) return;
    this.again = setTimeout(() => this.connect(), this.wait);
    this.wait = Math.min(this.wait * 2, BACK_OFF_MS.most);
  }

  /** The computer is awake or connected again: no need to wait. */
  hurry() {
    if (!this.socket) this.connect();
  }

  /** A cut that the browser has not noticed. */
  watch() {
    const dead = this.socket;
    if (dead?.readyState !== WebSocket.OPEN) return;
    const now = performance.now();
    const late = [...this.outbox.values()].some(({ sent }) => now - sent > ACKNOWLEDGED_WITHIN_MS);
    if (!late && now - this.heard < SILENT_MS) return;
    this.later();
    dead.close();
  }

  /** @param {PlayEvent} event @param {string} [name] what others may tell it as, too */
  tell(event, name) {
    const bytes = crypto.getRandomValues(new Uint8Array(12));
    const id = name ?? [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    this.outbox.set(id, { event, sent: 0 });
    this.sendOne(id);
  }

  /** @param {string} id */
  sendOne(id) {
    const one = this.outbox.get(id);
    if (!one || this.socket?.readyState !== WebSocket.OPEN) return;
    one.sent = performance.now();
    this.socket.send(JSON.stringify({ id, event: one.event }));
  }

  /** How everything will be once what is on its way has arrived. @param {State} state @returns {State} */
  expected(state) {
    const cells = { ...state.cells };
    let held = [...(state.held ?? [])];
    for (const { event } of this.outbox.values()) {
      const token = String(event["token"]);
      if (event.event === "lifted") held.push(token);
      if (event.event === "placed" || event.event === "put-back") held = held.filter((one) => one !== token);
      if (event.event === "placed") cells[token] = /** @type {[number, number]} */ (event["cell"]);
    }
    return { ...state, cells, held };
  }

  close() {
    this.closed.abort();
    clearInterval(this.watching);
    clearTimeout(this.again);
    const socket = this.socket;
    this.socket = null;
    socket?.close();
  }
}

/** @type {Stream | null} */
let stream = null;

// ---------------------------------------------------------------- what the stream shows

/** What the robot says aloud. */
const voice = {
  audio: new Audio(),
  /** What has been said already, and what a page that was just opened finds said. */
  number: -1,

  /** @param {Said | null} said @param {boolean} isNew whether it was said while the page was open */
  follow(said, isNew) {
    if (!said || said.number === this.number) return;
    this.number = said.number;
    if (!said.speech || !document.querySelector("[data-replay]")) return;
    this.audio.src = said.speech;
    if (isNew) this.play();
  },

  play() {
    this.audio.currentTime = 0;
    // Refused until somebody has touched the page; the sentence stands there all the same.
    this.audio.play().catch(() => {});
  },
};

/** @param {string} name @param {(element: HTMLElement) => void} change */
const each = (name, change) => all(`[data-show="${name}"]`).forEach(change);

/** @param {HTMLElement} element @param {string} text */
function write(element, text) {
  // A screen reader would say it again.
  if (element.textContent !== text) element.textContent = text;
}

/** The session and language whose page this is. */
let shown = "";

/** Show how everything is. @param {State} state */
function follow(state) {
  const isFirst = shown === "";
  const page = JSON.stringify([state.session, state.language, state.board, state.has_board]);
  if (shown !== page) {
    const drawn = document.getElementById("main")?.dataset["session"] ?? state.session ?? "";
    const isDrawn = drawn === (state.session ?? "") && state.language === document.documentElement.lang;
    const other = shown !== "" || !isDrawn;
    shown = page;
    // Another session, board or language: another page. Most often it is only the first message.
    if (other) void visit(location.href);
  }
  const expected = stream ? stream.expected(state) : state;
  const before = places();
  for (const root of all("[data-board][data-stream]")) boards.get(root)?.follow(expected);
  glide(before);
  each("sentence", (line) => write(line, state.said?.text ?? ""));
  each("question", (line) => write(line, state.question?.text ?? ""));
  each("phase", (part) => part.setAttribute("data-phase", state.phase));
  each("moves", (line) => write(line, String(state.moves ?? "")));
  each("face", (face) => face.setAttribute("data-expression", state.expression));
  each("lines", (list) => writeLines(list, state.view?.lines ?? []));
  when(state);
  voice.follow(state.said, !isFirst);
  lendHand(state);
  refresh(state);
}

let isRefreshing = false;

/** Ask for the page again where it is older than the state. @param {State} state */
function refresh(state) {
  const [place] = all("[data-refresh]");
  if (!place || isRefreshing || state.sequence <= Number(place.dataset["refresh"])) return;
  isRefreshing = true;
  setTimeout(async () => {
    await visit(location.href);
    isRefreshing = false;
    if (stream?.state) refresh(stream.state);
  }, REFRESH_MS);
}

/** Commands that the hand is about to carry out. @type {Set<string>} */
const inHand = new Set();

/**
 * The page is also the robot's hand, where it is the board: what the robot is to move glides after
 * a moment, so that it is seen where it was. Two pages tell the same under the same id.
 * @param {State} state
 */
function lendHand(state) {
  for (const { number, token, destination } of state.awaiting ?? []) {
    const id = `${state.session} ${number}`;
    if (!document.querySelector("[data-hand]") || inHand.has(id)) continue;
    inHand.add(id);
    setTimeout(() => {
      inHand.delete(id);
      const now = stream?.state;
      if (!stream || !now?.awaiting?.some((one) => one.number === number)) return;
      if (now.session !== state.session) return;
      stream.tell({ event: "placed", token, cell: destination }, `hand-${number}`);
      stream.tell({ event: "robot-done", command: number }, `done-${number}`);
      follow(now);
    }, HAND_MS);
  }
}

/** @param {HTMLElement} list @param {string[]} lines */
function writeLines(list, lines) {
  const now = [...list.children].map((line) => line.textContent);
  if (JSON.stringify(now) === JSON.stringify(lines)) return;
  list.replaceChildren(
    ...lines.map((text) => {
      const line = document.createElement("li");
      line.textContent = text;
      return line;
    }),
  );
}

/** Show what belongs to this moment. @param {State} state */
function when(state) {
  const facts = new Set([
    state.phase,
    `view-${state.view?.view}`,
    ...(state.question ? ["question", `matter-${state.question.matter}`] : []),
    ...(state.said?.speech ? ["speech"] : []),
    ...(state.connected ? [] : ["lost"]),
    ...(state.another_round ? ["another-round"] : []),
  ]);
  for (const part of all("[data-when]")) {
    part.hidden = !(part.dataset["when"] ?? "").split(" ").some((fact) => facts.has(fact));
  }
}

document.addEventListener("click", (event) => {
  const button = event.target instanceof Element ? event.target.closest("button") : null;
  if (!button || button.closest("[data-board]")) return;
  if (button.matches("[data-replay]")) {
    event.preventDefault();
    voice.play();
  } else if (button.dataset["event"] && stream) {
    event.preventDefault();
    /** @type {PlayEvent} */
    const told = JSON.parse(button.dataset["event"]);
    const question = stream.state?.question;
    if (told.event === "answered" && !question) return;
    stream.tell(told.event === "answered" ? { ...told, question: question?.number } : told);
  }
});

// ---------------------------------------------------------------- start

/** Bring to life what the page has now. */
function start() {
  const address = document.querySelector("[data-stream]")?.getAttribute("data-stream") ?? "";
  if (stream?.path !== address) {
    stream?.close();
    shown = "";
    const undo = () => all("[data-board]").forEach((root) => boards.get(root)?.undo());
    stream = address ? new Stream(address, follow, undo) : null;
  }
  for (const root of all("[data-board]")) {
    let board = boards.get(root);
    if (!board) {
      board = new Board(root);
      boards.set(root, board);
    }
    board.refresh();
  }
  if (stream?.state) follow(stream.state);
  document.documentElement.dataset["ready"] = "";
}

start();
