// What the self-check page and the page of a form have in common: the words, what the page carries, ways to answer.
// All HTML that is placed with `innerHTML` was written by the program that made the page, which escapes every text and response.

const texts = JSON.parse(element("texts").textContent);
const say = (key, values = {}) => texts[key].replace(/\{(\w+)\}/g, (_, name) => values[name]);

function element(id) {
  return document.getElementById(id);
}

/** A copy of a template of the page. */
function copy(id) {
  return element(id).content.firstElementChild.cloneNode(true);
}

function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// ── What the page carries ──────────────────────────────────────────────────────────────────────

/** The bytes that an element carries in base 93: two digits are 13 bits or 14, a last one is what a byte lacks. */
function carried(id) {
  const holder = element(id);
  const codes = new TextEncoder().encode(holder.textContent);
  holder.remove();
  const bytes = new Uint8Array(codes.length);
  const worth = (code) => code - (code > 60 ? 34 : 33);
  let [to, bits, count] = [0, 0, 0];
  for (let at = 0; at < codes.length; at += 2) {
    const isPair = at + 1 < codes.length;
    const value = worth(codes[at]) + (isPair ? 93 * worth(codes[at + 1]) : 0);
    bits |= value << count;
    count = isPair ? count + ((value & 0x1fff) > 456 ? 13 : 14) : 8;
    while (count >= 8) {
      bytes[to] = bits;
      to += 1;
      bits >>>= 8;
      count -= 8;
    }
  }
  return bytes.slice(0, to);
}

async function unpacked(id) {
  const stream = new Blob([carried(id)]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A WebAssembly module out of the streams that src/wasm/streams.py took it apart into. */
function joined(bytes) {
  const places = [0];
  /** The next number of a stream. */
  const number = (stream) => {
    for (let value = 0, shift = 0; ; shift += 7) {
      const byte = bytes[places[stream]++];
      value |= (byte & 127) << shift;
      if (byte < 128) return value;
    }
  };
  const functions = number(0);
  const forms = Array.from({ length: number(0) }, () => number(0));
  const lengths = Array.from({ length: 3 + 2 * forms.length }, () => number(0));
  let begin = places[0];
  lengths.forEach((length, stream) => {
    places[stream] = begin;
    begin += length;
  });

  // How long something is stands before it, in as many bytes as are kept for that.
  const out = new Uint8Array(bytes.length + 3 * functions + 16);
  const put = (place, value, width) => {
    for (let left = width; left > 0; left--, value >>>= 7) out[place++] = (value & 127) | (left > 1 ? 128 : 0);
  };
  out.set(bytes.subarray(places[0], places[0] + lengths[0]));
  const code = lengths[0] + 6;
  out[code - 6] = 10;
  put(code, functions, 4);
  let to = code + 4;
  for (let left = functions, next = places[2]; left > 0; left--) {
    const body = (to += 3);
    // Before its opcodes a function has its variables.
    for (let op = 256, depth = 1; ; op = bytes[next++]) {
      if (op < 256) out[to++] = op;
      const form = forms[op];
      let stream = 3 + 2 * op;
      if (form < 3) {
        for (let count = form; count > 0; count--, stream++) {
          let from = places[stream];
          do out[to++] = bytes[from];
          while (bytes[from++] > 127);
          places[stream] = from;
        }
      } else {
        for (let count = number(stream + 1); count > 0; count--) out[to++] = bytes[places[stream]++];
      }
      if (op > 1 && op < 5) depth++;
      else if (op === 11 && --depth === 0) break;
    }
    put(body - 3, to - body, 3);
  }
  put(code - 5, to - code, 5);
  out.set(bytes.subarray(places[1], places[1] + lengths[1]), to);
  return out.subarray(0, to + lengths[1]);
}

/** The marking program: JSON in, JSON out. */
class Grader {
  constructor(module, items) {
    this.module = module;
    this.items = items;
  }

  async start() {
    this.exports = (await WebAssembly.instantiate(await this.module, {})).exports;
    const error = this.call("load", this.items);
    if (error) throw new Error(error);
  }

  call(name, bytes) {
    const { memory, reserve, release } = this.exports;
    const start = reserve(bytes.length) >>> 0;
    new Uint8Array(memory.buffer).set(bytes, start);
    const packed = BigInt.asUintN(64, this.exports[name](start, bytes.length));
    const [at, length] = [Number(packed >> 32n), Number(packed & 0xffffffffn)];
    const reply = new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
    release(at, length);
    return reply;
  }

  ask(request) {
    try {
      const reply = JSON.parse(this.call("ask", new TextEncoder().encode(JSON.stringify(request))));
      if (reply.error) console.warn(reply.error);
      return reply;
    } catch (error) {
      // The program stopped in its tracks: a fresh one takes over.
      console.warn(error);
      this.start();
      return { error: String(error) };
    }
  }
}

// ── Ways to answer ─────────────────────────────────────────────────────────────────────────────

/** One line of text. */
function line(part) {
  const { part: asked, name } = part;
  const root = copy("t-line");
  const input = root.querySelector("input");
  input.id = `${name}-answer`;
  input.setAttribute("aria-describedby", part.described);
  root.querySelector("label").htmlFor = input.id;
  root.querySelector("label").textContent = say("answer", { letter: asked.letter });
  root.querySelector(".lead").innerHTML = asked.options.length ? say("order") : (asked.lead ?? "");
  root.querySelector(".unit").innerHTML = asked.unit ?? "";
  if (asked.options.length) root.prepend(lettered(asked.options));
  input.addEventListener("input", () => part.changed());
  return { root, value: () => input.value, fill: (response) => (input.value = response) };
}

/** Options with their letters, to be put in order. */
function lettered(options) {
  const item = ({ letter, text }) => make("li", { innerHTML: `<b>${letter}</b> ${text}` });
  return make("ul", { className: "ranking" }, ...options.map(item));
}

/** What is heard of a text with formulas. */
function spoken(element) {
  const copy = element.cloneNode(true);
  for (const math of copy.querySelectorAll("math[alttext]")) math.replaceWith(math.getAttribute("alttext"));
  return copy.textContent.trim();
}

/** Options to choose from. */
function options(part) {
  const { part: asked, name } = part;
  const type = asked.choosing === "several" ? "checkbox" : "radio";
  const legend = make("legend", {
    className: "visually-hidden",
    textContent: say("answer_option", { letter: asked.letter }),
  });
  const root = make("fieldset", {}, legend);
  root.setAttribute("aria-describedby", `${name}-asked`);
  const inputs = asked.options.map((option, at) => {
    const input = make("input", { type, name, value: option.letter, id: `${name}-${at}` });
    const label = make("label", { htmlFor: input.id, innerHTML: `<span>${option.letter})</span> ${option.text}` });
    // A formula alone is no name for all who read pages aloud.
    if (label.querySelector("math")) input.setAttribute("aria-label", spoken(label));
    input.addEventListener("change", () => part.changed());
    root.append(make("div", { className: "option" }, input, label));
    return input;
  });
  const chosen = () => inputs.filter((input) => input.checked).map((input) => input.value);
  const fill = (response) => {
    const letters = response.split(", ");
    inputs.forEach((input) => (input.checked = letters.includes(input.value)));
  };
  return { root, isChoice: true, value: () => chosen().join(", "), fill };
}

/** Entries of a matrix or a shape, with a line of text for those who rather type. */
function entries(part) {
  const { part: asked, name } = part;
  const { rows, columns } = asked;
  const text = line(part);
  const legend = make("legend", { className: "visually-hidden", textContent: say("answer", { letter: asked.letter }) });
  const grid = make("div", { className: "entries" });
  grid.style.gridTemplateColumns = `repeat(${columns}, minmax(3rem, 9rem))`;
  const cells = Array.from({ length: rows * columns }, (_, at) => {
    const cell = make("input", { type: "text", autocomplete: "off", spellcheck: false, maxLength: 400 });
    cell.setAttribute("autocapitalize", "off");
    cell.setAttribute("aria-describedby", part.described);
    const [row, column] = [Math.floor(at / columns) + 1, (at % columns) + 1];
    cell.setAttribute("aria-label", say("answer_entry", { row, column }));
    cell.addEventListener("input", () => part.changed());
    return cell;
  });
  grid.append(...cells);
  const lead = make("span", { className: "lead", innerHTML: asked.lead ?? "" });
  const unit = make("span", { className: "unit", innerHTML: asked.unit ?? "" });
  const field = make("div", { className: "field" }, lead, grid, unit);
  const other = make("button", { type: "button", textContent: say("typed") });
  const root = make("fieldset", {}, legend, field, text.root, make("p", {}, other));
  let isTyped = false;
  const change = (typed) => {
    isTyped = typed;
    field.hidden = typed;
    text.root.hidden = !typed;
    other.textContent = say(typed ? "entries" : "typed");
  };
  change(false);
  other.addEventListener("click", () => {
    if (!isTyped) text.fill(composed());
    change(!isTyped);
    part.changed();
  });
  const composed = () => {
    const values = cells.map((cell) => cell.value.trim());
    if (values.every((value) => value === "")) return "";
    const row = (at) => values.slice(at * columns, (at + 1) * columns).join(", ");
    if (columns === 1) return `(${values.join(", ")})`;
    return `[${Array.from({ length: rows }, (_, at) => `[${row(at)}]`).join(", ")}]`;
  };
  const fill = (response) => {
    const values = response.replace(/^[[(]+|[\])]+$/g, "").split(/\]\s*,\s*\[|,\s*/);
    const fits = values.length === cells.length;
    if (fits) cells.forEach((cell, at) => (cell.value = values[at]));
    if (!fits || composed() !== response) {
      text.fill(response);
      change(true);
    }
  };
  return { root, value: () => (isTyped ? text.value() : composed()), fill };
}

/**
 * Letters and unit as buttons under a field, which a tap puts in at the caret; phones have no ω.
 * All are one stop of the tab key, and the arrow keys go from one to the next.
 */
function keys(part) {
  const bar = part.find(".letters");
  if (!part.part.insertions.length) return bar.remove();
  bar.setAttribute("aria-label", say("letters", { letter: part.part.letter }));
  let field = part.find("input[type=text]");
  part.find(".answer").addEventListener("focusin", ({ target }) => {
    if (target.matches("input[type=text]")) field = target;
  });
  const put = (typed) => {
    if (field.closest("[hidden]")) field = [...part.root.querySelectorAll("input[type=text]")].find((own) => !own.closest("[hidden]"));
    const { selectionStart: from, selectionEnd: to, value } = field;
    // Letters that would run into each other become a product.
    const joins = /[\p{L}\d_')]$/u.test(value.slice(0, from)) && !typed.startsWith(" ");
    field.setRangeText((joins ? "*" : "") + typed, from, to, "end");
    field.focus();
    field.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const buttons = part.part.insertions.map(({ typed, symbol, name }) => {
    const button = make("button", { type: "button", innerHTML: symbol, tabIndex: -1 });
    button.setAttribute("aria-label", say("insert", { name }));
    // A tap leaves the caret where it is.
    button.addEventListener("pointerdown", (event) => event.preventDefault());
    button.addEventListener("click", () => put(typed));
    return button;
  });
  const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  const go = (to) => {
    buttons.forEach((button, at) => (button.tabIndex = at === to ? 0 : -1));
    buttons[to].focus();
  };
  bar.addEventListener("keydown", (event) => {
    const at = buttons.indexOf(document.activeElement);
    const count = buttons.length;
    const to = { Home: 0, End: count - 1 }[event.key] ?? (at + (steps[event.key] ?? 0) + count) % count;
    if (at < 0 || to === at) return;
    event.preventDefault();
    go(to);
  });
  buttons[0].tabIndex = 0;
  bar.append(...buttons);
}
