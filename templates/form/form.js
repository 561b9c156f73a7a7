// The page on which a sheet is answered: shows how answers are read, keeps them, and saves them to a file.
// What it carries knows no key: nothing here says whether an answer is right. It goes on from `common.js`.

/** What the file of answers is known by. */
const FORMAT = "vibank answers 1";

/** The sum of a text, by which a file is found out that was changed: SHA-256, in digits. */
function sum(text) {
  const bytes = new TextEncoder().encode(text);
  const primes = [];
  for (let at = 2; primes.length < 64; at += 1) if (primes.every((prime) => at % prime)) primes.push(at);
  const fraction = (value) => Math.floor((value - Math.floor(value)) * 2 ** 32) | 0;
  const state = primes.slice(0, 8).map((prime) => fraction(Math.sqrt(prime)));
  const constants = primes.map((prime) => fraction(Math.cbrt(prime)));
  const padded = new Uint8Array(Math.ceil((bytes.length + 9) / 64) * 64);
  padded.set(bytes);
  padded[bytes.length] = 0x80;
  const view = new DataView(padded.buffer);
  view.setUint32(padded.length - 8, Math.floor(bytes.length / 2 ** 29));
  view.setUint32(padded.length - 4, bytes.length * 8);
  const turn = (word, by) => (word >>> by) | (word << (32 - by));
  for (let block = 0; block < padded.length; block += 64) {
    const words = Array.from({ length: 16 }, (_, at) => view.getInt32(block + 4 * at));
    for (let at = 16; at < 64; at += 1) {
      const [early, late] = [words[at - 15], words[at - 2]];
      const first = turn(early, 7) ^ turn(early, 18) ^ (early >>> 3);
      const second = turn(late, 17) ^ turn(late, 19) ^ (late >>> 10);
      words.push((words[at - 16] + first + words[at - 7] + second) | 0);
    }
    let [a, b, c, d, e, f, g, h] = state;
    for (let at = 0; at < 64; at += 1) {
      const one = (h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) + constants[at] + words[at]) | 0;
      const two = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [a, b, c, d, e, f, g, h] = [(one + two) | 0, a, b, c, (d + one) | 0, e, f, g];
    }
    [a, b, c, d, e, f, g, h].forEach((word, at) => (state[at] = (state[at] + word) | 0));
  }
  return state.map((word) => (word >>> 0).toString(16).padStart(8, "0")).join("");
}

/** What the sum of a file is made of: the code, and a line for each answer. */
function summed(code, answers) {
  const line = ({ question, part, response }) => `${question}${part}\t${response}\n`;
  return `${code}\n${answers.map(line).join("")}`;
}

/** One part with its answer. */
class Part {
  constructor(form, question, at, part) {
    Object.assign(this, { form, question, at, part });
    this.place = `${question.number}${part.letter}`;
    this.name = `part-${this.place}`;
    this.response = "";
    this.state = "empty";
    this.root = copy("t-part");
    const heading = this.find("h3");
    heading.append(make("span", { ariaHidden: "true", textContent: `${part.letter})` }));
    heading.append(make("span", { className: "visually-hidden", textContent: say("part", { letter: this.place }) }));
    heading.id = this.name;
    this.root.setAttribute("aria-labelledby", this.name);
    for (const of of ["ask", "asked", "echo"]) this.find(`.${of}`).id = `${this.name}-${of}`;
    this.find(".ask").innerHTML = part.ask;
    this.find(".asked").innerHTML = part.asked;
    this.group = /\d$/.test(part.letter) && this.name.replace(/\d+$/, "");
    const shared = this.group ? `${this.group}-ask ` : "";
    this.described = shared + ["ask", "asked", "echo"].map((of) => `${this.name}-${of}`).join(" ");
    this.isWork = part.kind === "work";
    this.input = this.field();
    this.find(".answer").append(this.input.root);
    keys(this);
    if (this.input.isChoice || this.isWork) this.find(".format").remove();
    else this.find(".format p").textContent = say(`format_${part.kind}`);
  }

  find(selector) {
    return this.root.querySelector(selector);
  }

  opened() {
    if (this.group) this.root.classList.add("blank");
    const { group } = this.part;
    if (!group) return [this.root];
    const opens = make("section", { className: "part opens" });
    opens.append(make("h3", { textContent: `${group.letter})` }), make("div", { id: `${this.group}-ask`, innerHTML: group.ask }));
    return [opens, this.root];
  }

  field() {
    if (this.isWork) return { root: make("p", { textContent: say("form_work") }), value: () => "", fill: () => {} };
    if (this.part.options.length > 0 && this.part.choosing !== "ranking") return options(this);
    if (this.part.rows) return entries(this);
    return line(this);
  }

  fill(response) {
    this.response = response;
    this.input.fill(response);
    this.read();
  }

  changed() {
    this.response = this.input.value().trim();
    this.form.keep();
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => {
      this.read();
      this.form.count();
    }, 150);
  }

  /** Shows how the answer is read: this depends on no key. */
  read() {
    const place = this.find(".echo");
    place.classList.remove("unread");
    this.state = this.response === "" ? "empty" : "read";
    if (this.response === "" || this.input.isChoice) return place.replaceChildren();
    // What cannot be read here is kept as it is typed.
    if (!this.part.reads) return place.replaceChildren(say("form_unchecked"));
    const request = { do: "read", question: this.at, code: this.form.code, part: this.part.reads, response: this.response };
    const { reading, other, problem, error } = this.form.grader.ask(request);
    if (error) return place.replaceChildren(say("form_unchecked"));
    if (!reading) this.state = "unread";
    place.classList.toggle("unread", !reading);
    const said = other ? `${reading} ${say("or")} ${other}` : (reading ?? problem);
    place.replaceChildren(
      make("span", { textContent: `${say(reading ? "read_as" : "unreadable")}: ` }),
      make("span", { innerHTML: said ?? "" }),
    );
  }
}

/** What is wider than the screen scrolls by itself, and can be scrolled from the keyboard. */
function reachable() {
  for (const box of document.querySelectorAll(".statement, .ask, .echo")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
}

class Form {
  constructor({ code, title, sheet, questions }, grader) {
    Object.assign(this, { code, title, sheet, grader });
    this.parts = questions.flatMap((question, at) => question.parts.map((part) => new Part(this, question, at, part)));
    for (const part of this.parts) {
      const place = document.querySelector(`[data-question="${part.question.number}"]`);
      place.append(...part.opened());
    }
    this.restore();
    this.count();
    reachable();
    addEventListener("resize", reachable);
    element("save").addEventListener("click", () => this.save());
    element("load").addEventListener("change", ({ target }) => this.load(target));
    element("forget").addEventListener("click", () => this.forget());
  }

  get key() {
    return `vibank form ${this.sheet} ${this.code}`;
  }

  keep() {
    try {
      const answers = this.parts.map(({ place, response }) => [place, response]);
      localStorage.setItem(this.key, JSON.stringify(Object.fromEntries(answers)));
      this.isSaved = false;
    } catch {
      element("kept").hidden = false;
    }
  }

  restore() {
    try {
      const kept = JSON.parse(localStorage.getItem(this.key) ?? "{}");
      for (const part of this.parts) if (kept[part.place]) part.fill(kept[part.place]);
    } catch {
      element("kept").hidden = false;
    }
  }

  /** How many parts are answered, and which answers cannot be read. */
  count() {
    const asked = this.parts.filter((part) => !part.isWork);
    const done = asked.filter((part) => part.state !== "empty");
    element("answered").textContent = say("form_answered", { done: done.length, all: asked.length });
    const unread = asked.filter((part) => part.state === "unread");
    const item = (part) => {
      const link = make("a", { href: `#${part.name}`, textContent: say("form_unread", { part: part.place }) });
      link.addEventListener("click", (event) => {
        event.preventDefault();
        part.root.querySelector("input").focus();
      });
      return make("li", {}, link);
    };
    element("unread").replaceChildren(...unread.map(item));
  }

  answers() {
    const asked = this.parts.filter((part) => !part.isWork);
    return asked.map(({ question, part, response }) => ({ question: question.number, part: part.letter, response }));
  }

  save() {
    for (const part of this.parts) {
      clearTimeout(part.waiting);
      part.read();
    }
    this.count();
    const { code, title, sheet } = this;
    const answers = this.answers();
    const file = { format: FORMAT, code, title, sheet, answers, sum: sum(summed(code, answers)) };
    const blob = new Blob([`${JSON.stringify(file, null, 1)}\n`], { type: "application/json" });
    const link = make("a", { href: URL.createObjectURL(blob), download: `answers-${code}.json` });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    element("saved").textContent = say("form_saved", { file: link.download });
  }

  /** Goes on with a file that was saved before. */
  async load(input) {
    const place = element("saved");
    try {
      const file = JSON.parse(await input.files[0].text());
      if (file.format !== FORMAT || file.code !== this.code) throw new Error("of another sheet");
      for (const part of this.parts) {
        const own = file.answers.find(({ question, part: letter }) => question === part.question.number && letter === part.part.letter);
        part.fill(own?.response ?? "");
      }
      this.keep();
      this.count();
      place.textContent = say("form_loaded");
    } catch {
      place.textContent = say("form_not_loaded", { code: this.code });
    }
    input.value = "";
  }

  forget() {
    if (!confirm(say("form_forget_really"))) return;
    this.parts.forEach((part) => part.fill(""));
    this.keep();
    this.count();
    element("saved").textContent = "";
  }
}

async function begin() {
  if (!globalThis.DecompressionStream || !globalThis.WebAssembly) throw new Error("too old");
  const code = unpacked("grader").then((bytes) => WebAssembly.compile(joined(bytes)));
  document.fonts.add(new FontFace("Vibank Math", carried("font")));
  const items = await unpacked("items");
  const grader = new Grader(code, items);
  await grader.start();
  globalThis.page = new Form(JSON.parse(element("form").textContent), grader);
  document.documentElement.dataset.ready = Math.round(performance.now());
}

begin().catch((error) => {
  console.error(error);
  element("failed").hidden = false;
  element("failed").textContent = say(error.message === "too old" ? "too_old" : "form_failed");
});
