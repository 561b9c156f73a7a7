// The self-check page: shows what the grader says, and keeps what the student did.
// All HTML that is placed with `innerHTML` was written by the grader, which escapes every text and response.
// It goes on from `common.js`.

// ── What the student did ───────────────────────────────────────────────────────────────────────

/** State of the page, kept in this browser alone; where that is denied, until the page is closed. */
class Memory {
  constructor(name) {
    this.name = `vibank practice ${name}`;
    this.questions = {};
    this.current = "";
    this.submitted = false;
    try {
      const kept = JSON.parse(localStorage.getItem(this.name) ?? "{}");
      if (kept.questions) Object.assign(this, kept);
      localStorage.setItem(this.name, JSON.stringify(kept));
    } catch {
      element("kept").hidden = false;
    }
  }

  keep() {
    try {
      const { questions, current, submitted } = this;
      localStorage.setItem(this.name, JSON.stringify({ questions, current, submitted }));
    } catch {
      element("kept").hidden = false;
    }
  }

  question(key) {
    return (this.questions[key] ??= { code: "", status: "new", parts: {} });
  }

  forget() {
    this.questions = {};
    this.submitted = false;
    this.keep();
  }
}

// ── The page ───────────────────────────────────────────────────────────────────────────────────

const MARKS = { new: "○", tried: "◔", seen: "◐", done: "●" };

/** The rules of a page on its own. */
const FREE = { attempts: null, feedback: "at once", isSilent: false, solution: "always" };

/** By what a question is known here and in a course: its item, its parts where not all are asked, and data that are fixed. */
const keyOf = ({ item, parts = [], set = [] }) => [item, ...parts, ...set.map(([name, value]) => `${name}=${value}`)].join(" ");

class Page {
  /** In a course, what keeps the answers is the course itself. */
  constructor(practice, grader, memory, course) {
    Object.assign(this, { practice, grader, memory, course, rules: course?.rules ?? FREE });
    this.keys = practice.questions.map(keyOf);
    this.list();
    element("topic").addEventListener("change", () => this.filter());
    element("forget").addEventListener("click", () => this.forget());
    element("forget").hidden = Boolean(course?.platform);
    element("submit")?.addEventListener("click", () => this.submit());
    addEventListener("hashchange", () => this.open(this.wanted(), true));
    this.open(this.wanted(), false);
  }

  /** The question and variant that the address names, else those of last time. */
  wanted() {
    const address = decodeURIComponent(location.hash.slice(1));
    const named = address.match(/\/([0-9A-Za-z]{3}-[0-9A-Za-z]{3}-[0-9A-Za-z]{3})$/)?.[1];
    const item = named ? address.slice(0, -named.length - 1) : address;
    const code = this.course?.isPinned ? undefined : named;
    const number = this.practice.questions.findIndex((question) => question.item === item);
    if (number >= 0) return { number, code };
    return { number: Math.max(0, this.keys.indexOf(this.memory.current)) };
  }

  list(course = this.course) {
    const topics = new Map();
    let chapter = null;
    this.links = this.practice.questions.map((question, number) => {
      question.topics.forEach((topic) => topics.set(topic, [...(topics.get(topic) ?? []), number]));
      if (chapter?.title !== question.chapter) {
        const title = make("h2", { textContent: question.chapter });
        const list = make("ol");
        chapter = { title: question.chapter };
        element("list").append(make("section", {}, title, list));
      }
      const mark = make("span", { className: "mark", ariaHidden: "true" });
      const words = make("span", { className: "visually-hidden" });
      const link = make("a", { href: `#${question.item}` }, mark, make("span", { textContent: question.title }), words);
      element("list").lastElementChild.lastElementChild.append(make("li", {}, link));
      return { link, mark, words };
    });
    this.topics = [...topics].sort(([a], [b]) => a.localeCompare(b, document.documentElement.lang));
    for (const [topic] of this.topics) {
      element("topic").append(make("option", { value: topic, textContent: topic }));
    }
    this.meters = this.topics.map(([topic, numbers], at) => {
      const id = `topic-${at}`;
      const meter = make("progress", { max: numbers.length });
      meter.setAttribute("aria-labelledby", id);
      const words = make("span");
      element("topics").append(make("li", {}, make("span", { id, textContent: topic }), words, meter));
      return { meter, words, numbers };
    });
    element("footer").textContent = say(course?.platform ? "footer_course" : "footer", { program: this.practice.program });
    if (matchMedia("(max-width: 52rem)").matches) element("contents").open = false;
    this.score();
  }

  filter() {
    const topic = element("topic").value;
    this.practice.questions.forEach((question, number) => {
      this.links[number].link.parentElement.hidden = topic !== "" && !question.topics.includes(topic);
    });
    for (const section of element("list").children) {
      section.hidden = [...section.querySelectorAll("li")].every((item) => item.hidden);
    }
  }

  /** Shows how far the student has come. */
  score() {
    const status = (number) => this.memory.questions[this.keys[number]]?.status ?? "new";
    this.links.forEach(({ link, mark, words }, number) => {
      mark.textContent = MARKS[status(number)];
      words.textContent = `(${say(`status_${status(number)}`)})`;
      if (number === this.number) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    });
    const show = (meter, words, numbers) => {
      const done = numbers.filter((number) => status(number) === "done").length;
      meter.max = numbers.length;
      meter.value = done;
      words.textContent = say("done_of", { done, all: numbers.length });
    };
    this.meters.forEach(({ meter, words, numbers }) => show(meter, words, numbers));
    show(element("score"), element("score-words"), this.links.map((_, number) => number));
    if (this.course) this.standing();
  }

  /** What is known of verdicts: all of them, or none where nothing is said before all is submitted. */
  get isSilent() {
    return this.rules.isSilent && !(this.memory.submitted && this.rules.feedback === "after submitting");
  }

  /** How it stands in the course. */
  standing() {
    const { share, answered } = this.course.result();
    const percent = (of) => Math.floor(1000 * of + 1e-6) / 10;
    const words = say(this.isSilent ? "answered_share" : "points_share", { percent: percent(this.isSilent ? answered : share) });
    if (this.isSilent) {
      element("score").value = answered * element("score").max;
      element("score-words").textContent = words;
    } else {
      element("score-words").textContent += ` · ${words}`;
    }
    const submit = element("submit");
    submit.hidden = !this.rules.isSilent;
    submit.disabled = this.memory.submitted;
    submit.textContent = say(this.memory.submitted ? "submitted" : "submit");
  }

  submit() {
    if (!confirm(say("submit_really"))) return;
    this.keepTyped();
    this.course.submit();
    this.open({ number: this.number }, true);
  }

  /** Answers that were typed and not kept are handed in, too: nobody sees that a button was missed. */
  keepTyped() {
    const isTyped = (record) => !record.verdict && Boolean(record.response?.trim());
    const { number: shown } = this;
    this.keys.forEach((key, number) => {
      if (!Object.values(this.memory.questions[key]?.parts ?? {}).some(isTyped)) return;
      if (number !== this.number) this.open({ number }, false);
      this.stage.parts.filter(({ record }) => isTyped(record)).forEach((part) => part.mark());
    });
    if (this.number !== shown) this.open({ number: shown }, false);
  }

  forget() {
    if (!confirm(say("forget_really"))) return;
    this.memory.forget();
    this.open({ number: this.number }, true);
  }

  /** A new variant: data that the student has not seen. */
  fresh(number) {
    if (this.course?.isPinned) return this.grader.ask({ do: "choose", question: number, from: this.course.from(number) }).code;
    const [high, low] = crypto.getRandomValues(new Uint32Array(2));
    const from = (high % 256) * 2 ** 32 + low;
    return this.grader.ask({ do: "choose", question: number, from }).code;
  }

  open({ number, code }, focus) {
    const record = this.memory.question(this.keys[number]);
    const variant = code?.toUpperCase() ?? (record.code || this.fresh(number));
    if (record.code && record.code !== variant) record.parts = {};
    record.code = variant;
    this.number = number;
    this.memory.current = this.keys[number];
    this.memory.keep();
    this.stage = new Question(this, number, record);
    element("stage").replaceChildren(this.stage.root);
    const { item } = this.practice.questions[number];
    history.replaceState(null, "", this.course?.isPinned ? `#${item}` : `#${item}/${record.code}`);
    this.score();
    requestAnimationFrame(() => this.reveal());
    if (focus) this.stage.root.querySelector("h2").focus();
  }

  /** Brings the question into sight in the list, without moving the page. */
  reveal() {
    const [list, { link }] = [element("list"), this.links[this.number]];
    const at = link.offsetTop - list.scrollTop;
    if (at < 0 || at + link.offsetHeight > list.clientHeight) list.scrollTop = link.offsetTop - list.clientHeight / 3;
  }

  another() {
    const code = this.fresh(this.number);
    this.open({ number: this.number, code }, true);
    element("announce").textContent = say("new_instance", { code });
  }
}

/** One question on the stage. */
class Question {
  constructor(page, number, record) {
    Object.assign(this, { page, number, record });
    const about = page.practice.questions[number];
    this.root = copy("t-question");
    const find = (selector) => this.root.querySelector(selector);
    find("h2").textContent = about.title;
    find(".about").textContent = [
      about.chapter,
      say("level", { level: about.level }),
      say("minutes", { minutes: about.minutes }),
    ].join(" · ");
    const shown = this.ask("show");
    if (shown.error) {
      find(".statement").append(make("p", { className: "notice", textContent: say("failed") }));
      this.parts = [];
    } else {
      find(".statement").innerHTML = shown.statement;
      find(".identity").append(say("code"), " ", make("b", { textContent: record.code }), ` · ${shown.identity}`);
      this.parts = shown.parts.map((part) => new Part(this, part));
      find(".parts").append(...this.parts.flatMap((part) => part.opened()));
      this.parts.forEach((part) => part.restore());
    }
    const on = (name, action) => find(`[data-do=${name}]`).addEventListener("click", action);
    on("another", () => page.another());
    on("print", () => print());
    on("link", () => this.link());
    // In a course, each learner has data of their own, and no other.
    for (const name of ["another", "link"]) find(`[data-do=${name}]`).hidden = Boolean(page.course?.isPinned);
    const step = (name, to) => {
      on(name, () => page.open({ number: to }, true));
      find(`[data-do=${name}]`).disabled = !page.practice.questions[to];
    };
    step("previous", number - 1);
    step("next", number + 1);
  }

  ask(what, more = {}) {
    return this.page.grader.ask({ do: what, question: this.number, code: this.record.code, ...more });
  }

  async link() {
    try {
      await navigator.clipboard.writeText(location.href);
      element("announce").textContent = say("link_copied");
      this.root.querySelector("[data-do=link]").textContent = say("link_copied");
    } catch {
      this.root.querySelector("[data-do=link]").replaceWith(say("link_here"));
    }
  }

  /** What was answered to the parts before this one. */
  earlier(part) {
    const before = this.parts.slice(0, this.parts.indexOf(part));
    const answered = before.filter((other) => other.record.verdict && other.record.response);
    return Object.fromEntries(answered.map((other) => [other.id, other.record.response]));
  }

  /** Offers to show the system in motion with the first solution that is seen; nothing is computed before. */
  offerMotion(place) {
    if (this.motion) return;
    const button = make("button", { type: "button", textContent: say("motion") });
    this.motion = make("div", { className: "motion" }, button);
    button.addEventListener("click", () => {
      this.motion.replaceChildren();
      new Moving(this, this.motion).begin();
    });
    // What changes with each picture is nothing to be announced, so it comes after the solution.
    place.after(this.motion);
  }

  /** A solution that was seen freezes the credit of its question. */
  get isFrozen() {
    return this.parts.some((part) => part.record.solved);
  }

  /** Takes stock after a mark or a look at a solution. */
  settle() {
    const records = this.parts.map((part) => part.record);
    if (this.page.isSilent) {
      this.record.status = "tried";
      this.page.memory.keep();
      return this.page.score();
    }
    // Work on paper is not marked, and nobody has to look at its solution.
    const right = this.parts.every((part) => part.isWork || part.record.verdict === "right");
    const seen = records.some((record) => record.solved);
    const best = this.record.status === "done" || (right && !seen) ? "done" : seen ? "seen" : "tried";
    this.record.status = best;
    this.page.memory.keep();
    this.page.score();
  }
}

/** One part of a question with its answer. */
class Part {
  constructor(question, part) {
    Object.assign(this, { question, part, id: part.id });
    const { parts } = question.record;
    const old = part.was?.find((id) => id in parts);
    this.record = parts[part.id] ??= parts[old] ?? { response: "", attempts: 0, hints: 0 };
    this.root = copy("t-part");
    this.name = `part-${part.letter}`;
    const heading = this.find("h3");
    heading.append(make("span", { ariaHidden: "true", textContent: `${part.letter})` }));
    heading.append(make("span", { className: "visually-hidden", textContent: say("part", { letter: part.letter }) }));
    heading.id = this.name;
    this.root.setAttribute("aria-labelledby", this.name);
    this.find(".ask").innerHTML = part.ask;
    this.find(".ask").id = `${this.name}-ask`;
    this.find(".echo").id = `${this.name}-echo`;
    this.find(".asked").innerHTML = part.asked;
    this.find(".asked").id = `${this.name}-asked`;
    /** What describes a field: the question, what its line asks for, how the answer is read. */
    /** Of a blank, such as `b2`: the name of its group. */
    this.group = /\d$/.test(part.letter) && this.name.replace(/\d+$/, "");
    const shared = this.group ? `${this.group}-ask ` : "";
    this.described = shared + ["ask", "asked", "echo"].map((of) => `${this.name}-${of}`).join(" ");
    /** Work on paper: nothing is typed, and it counts for nothing. */
    this.isWork = part.kind === "work";
    this.input = this.field();
    this.find(".answer").append(this.input.root);
    keys(this);
    if (this.isWork) this.find("[type=submit]").remove();
    if (this.input.isChoice || this.isWork) this.find(".format").remove();
    else this.find(".format p").textContent = say(`format_${part.kind}`);
    this.find("form").addEventListener("submit", (event) => {
      event.preventDefault();
      if (!this.isWork) this.mark();
    });
    this.find("[data-do=hint]").addEventListener("click", () => this.hint());
    this.find("[data-do=solve]").addEventListener("click", () => this.solve());
  }

  find(selector) {
    return this.root.querySelector(selector);
  }

  /** Its section, after what the blanks of its group have in common where it is the first of them. */
  opened() {
    if (this.group) this.root.classList.add("blank");
    const { group } = this.part;
    if (!group) return [this.root];
    const opens = make("section", { className: "part opens" });
    opens.append(make("h3", { textContent: `${group.letter})` }), make("div", { className: "ask", id: `${this.group}-ask`, innerHTML: group.ask }));
    return [opens, this.root];
  }

  ask(what, more = {}) {
    return this.question.ask(what, { part: this.id, ...more });
  }

  /** The way in which this part is answered. */
  field() {
    if (this.isWork) return { root: make("p", { textContent: say("work") }) };
    if (this.part.options.length > 0 && this.part.choosing !== "ranking") return options(this);
    if (this.part.rows) return entries(this);
    return line(this);
  }

  /** Shows what was done before the page was opened again. */
  restore() {
    if (this.record.response) {
      this.input.fill(this.record.response);
      this.echo();
    }
    const { verdict, response } = this.record;
    if (verdict && response) this.tell(this.ask("mark", this.asked(response)));
    else if (verdict) this.tell({ verdict, feedback: say("text_not_kept") });
    for (let number = 0; number < this.record.hints; number += 1) this.addHint(number);
    if (this.record.solved) this.addSolution();
    this.refresh();
  }

  refresh() {
    const { attempts, hints, solved } = this.record;
    const hint = this.find("[data-do=hint]");
    hint.hidden = this.part.hints === 0;
    hint.disabled = hints >= this.part.hints;
    hint.textContent = say(hints > 0 ? "next_hint" : "hint");
    const { rules, memory } = this.question.page;
    const solve = this.find("[data-do=solve]");
    const isDue = rules.solution === "always" || (rules.isSilent ? memory.submitted : attempts > 0 || this.isWork);
    solve.hidden = rules.solution === "never" || !isDue;
    solve.disabled = Boolean(solved);
    const isOver = (rules.isSilent && memory.submitted) || (rules.attempts && !rules.isSilent && attempts >= rules.attempts);
    const check = this.find("[type=submit]");
    if (check) {
      check.disabled = Boolean(isOver);
      check.textContent = say(rules.isSilent ? "keep" : "check");
    }
    for (const input of this.find(".answer").querySelectorAll("input, button")) input.disabled = Boolean(isOver);
    this.find(".attempts").textContent =
      attempts === 0 ? "" : say(attempts === 1 ? "attempts_one" : "attempts", { count: attempts });
  }

  /** The answer was changed: it is read again, and marks of another answer are taken away. */
  changed() {
    this.record.response = this.input.value();
    this.record.at = Date.now();
    if (this.record.verdict) {
      delete this.record.verdict;
      this.find(".feedback").replaceChildren();
      this.find(".feedback").className = "feedback";
    }
    this.question.page.memory.keep();
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.echo(), 150);
  }

  echo() {
    const place = this.find(".echo");
    const response = this.record.response.trim();
    if (response === "" || this.input.isChoice) return place.replaceChildren();
    const { reading, other, problem } = this.ask("read", { response });
    const said = other ? `${reading} ${say("or")} ${other}` : (reading ?? problem);
    const lead = `${say(reading ? "read_as" : "unreadable")}: `;
    place.replaceChildren(make("span", { textContent: lead }), make("span", { innerHTML: said ?? "" }));
  }

  asked(response) {
    return { response, earlier: this.question.earlier(this) };
  }

  mark() {
    clearTimeout(this.waiting);
    this.record.response = this.input.value();
    const marking = this.ask("mark", this.asked(this.record.response));
    if (marking.error) return this.show({ verdict: "unreadable", feedback: "" });
    const counts = ["right", "partial", "wrong"].includes(marking.verdict);
    if (counts) {
      this.record.attempts += 1;
      this.record.verdict = marking.verdict;
      this.reward(marking.credit);
    } else {
      delete this.record.verdict;
    }
    if (marking.reading) this.echo();
    else this.find(".echo").replaceChildren();
    this.tell(marking);
    this.refresh();
    const { course, number } = this.question.page;
    if (counts) course?.marked(number, this.id, this.record);
    this.question.settle();
  }

  /** Keeps what an answer is worth: the best of all, or the last where nothing is said before all is submitted. */
  reward(credit) {
    const { record } = this;
    const isFrozen = this.question.isFrozen;
    record.markedCredit = isFrozen ? (record.credit ?? 0) : credit;
    if (isFrozen) return;
    record.credit = this.question.page.rules.isSilent ? credit : Math.max(record.credit ?? 0, credit);
  }

  /** Shows marks, or where these have to wait, that the answer was kept. */
  tell(marking) {
    const counts = ["right", "partial", "wrong"].includes(marking.verdict);
    if (!counts || !this.question.page.isSilent) return this.show(marking);
    const place = this.find(".feedback");
    place.className = "feedback";
    const words = this.record.response ? say("answer_kept") : say("text_not_kept");
    place.replaceChildren(make("p", { className: "verdict", textContent: words }));
  }

  show({ verdict, feedback, reasons = [] }) {
    const place = this.find(".feedback");
    place.className = `feedback ${verdict}`;
    const key = reasons.includes("follow-through") ? "verdict_follow" : `verdict_${verdict}`;
    const title = make("p", { className: "verdict", textContent: say(key) });
    place.replaceChildren(title, make("div", { innerHTML: feedback }));
    // A sentence that says the verdict again is left out.
    if (place.lastElementChild.textContent.trim() === `${title.textContent}.`) place.lastElementChild.remove();
  }

  addHint(number) {
    const title = make("h4", { textContent: say("hint_number", { number: number + 1 }) });
    const text = make("div", { innerHTML: this.ask("hint", { number }).html ?? "" });
    this.find(".hints").append(make("section", {}, title, text));
  }

  hint() {
    this.addHint(this.record.hints);
    this.record.hints += 1;
    this.refresh();
    this.question.page.course?.seen();
    this.question.settle();
  }

  addSolution() {
    const { key, html, moves, error } = this.ask("solve");
    const place = this.find(".solution");
    if (error) return place.replaceChildren(make("p", { textContent: error }));
    const value = make("p", { className: "value" });
    value.append(`${say("key")}: `, make("span", { innerHTML: this.part.options.length ? this.chosen() : key }));
    if (this.isWork) value.textContent = say("work_compare");
    place.replaceChildren(make("h4", { textContent: say("solution") }), value, make("div", { innerHTML: html }));
    if (moves) this.question.offerMotion(place);
  }

  /** The right options in words. */
  chosen() {
    const { right } = this.ask("solve");
    const option = (id) => this.part.options.find((known) => known.id === id);
    return right.map((id) => `${option(id).letter}) ${option(id).text}`).join(" ");
  }

  solve() {
    this.record.solved = true;
    this.addSolution();
    this.refresh();
    this.question.page.course?.seen();
    this.question.settle();
  }
}

// ── The system in motion ───────────────────────────────────────────────────────────────────────

const DASHES = ["", "7 4", "2 3", "10 3 2 3"];

/** Pictures a second at full speed. */
const RATE = 30;

/** The figure as the solver lets it move. It never starts by itself, and stays still where less motion is asked for. */
class Moving {
  constructor(question, root) {
    Object.assign(this, { question, root, run: 0, at: 0, isSlow: false });
    this.isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  begin() {
    const button = (name, action) => {
      const made = make("button", { type: "button", textContent: say(name) });
      made.addEventListener("click", action);
      return made;
    };
    const labelled = (name, control) => make("label", {}, `${say(name)} `, control);
    this.choice = make("select");
    this.choice.addEventListener("change", () => this.show(Number(this.choice.value)));
    this.play = button("play", () => (this.isPlaying ? this.stop() : this.start()));
    this.slow = button("slow", () => {
      this.isSlow = !this.isSlow;
      this.slow.setAttribute("aria-pressed", this.isSlow);
    });
    this.slow.setAttribute("aria-pressed", "false");
    this.time = make("input", { type: "range", min: 0, step: 1 });
    this.time.addEventListener("input", () => {
      this.stop();
      this.turnTo(Number(this.time.value));
    });
    this.screen = make("div", { className: "screen" });
    this.trace = make("div", { className: "trace" });
    this.table = make("div");
    this.note = make("p", { className: "note" });
    const controls = make("p", { className: "actions" }, labelled("motion_of", this.choice));
    if (!this.isCalm) controls.append(this.play, this.slow);
    controls.append(labelled("time", this.time));
    const turning = make("details", {}, make("summary", { textContent: say("turning_points") }), this.table);
    this.root.append(make("h4", { textContent: say("motion_title") }), controls, this.screen, this.trace, this.note, turning);
    this.show(0);
    this.choice.focus();
  }

  /** Shows one of the motions, at rest at its beginning. */
  show(run) {
    this.stop();
    const film = this.question.ask("move", { run });
    if (film.error) return this.root.replaceChildren(make("p", { textContent: say("motion_none") }));
    Object.assign(this, { run, film });
    const name = ([kind, number]) => say(film.symbols.length === 1 && kind === "mode" ? "run_free" : `run_${kind}`, { number });
    this.choice.replaceChildren(...film.runs.map((own, at) => make("option", { value: at, textContent: name(own), selected: at === run })));
    this.screen.innerHTML = film.svg;
    const [kind] = film.runs[run];
    const shown = film.frames.length / RATE;
    this.note.textContent = [
      say(this.isCalm ? "motion_calm" : "motion_speed", { seconds: Number(film.seconds.toPrecision(3)), shown: shown.toFixed(0) }),
      say(kind === "mode" ? "motion_mode" : "motion_scale"),
    ].join(" ");
    this.time.max = film.frames.length - 1;
    this.plot();
    this.list();
    this.turnTo(0);
  }

  /** The trace of each coordinate, and a line at the moment that is shown. */
  plot() {
    const { shares, symbols } = this.film;
    const [width, height] = [600, 120];
    const drawn = (tag, attributes) => {
      const made = document.createElementNS(this.screen.firstElementChild.namespaceURI, tag);
      for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
      return made;
    };
    const svg = drawn("svg", { viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" });
    svg.append(drawn("path", { d: `M0 ${height / 2}H${width}`, stroke: "currentColor", "stroke-opacity": 0.4 }));
    shares.forEach((own, place) => {
      const points = own.map((share, at) => `${((at * width) / (own.length - 1)).toFixed(1)},${(height / 2 - share * (height / 2 - 4)).toFixed(1)}`);
      svg.append(drawn("polyline", { points: points.join(" "), fill: "none", stroke: "currentColor", "stroke-width": 1.6, "stroke-dasharray": DASHES[place % DASHES.length] }));
    });
    this.now = drawn("path", { stroke: "currentColor", "stroke-width": 1 });
    svg.append(this.now);
    const legend = make("p", { className: "legend" });
    symbols.forEach((symbol, place) => {
      const line = drawn("svg", { viewBox: "0 0 40 8", width: 40, height: 8, "aria-hidden": "true" });
      line.append(drawn("path", { d: "M0 4H40", stroke: "currentColor", "stroke-width": 1.6, "stroke-dasharray": DASHES[place % DASHES.length] }));
      legend.append(make("span", {}, line, " ", make("span", { innerHTML: symbol })));
    });
    this.trace.replaceChildren(svg, legend);
  }

  /** The turning points as a table, for those who see no picture. */
  list() {
    const { turns, symbols } = this.film;
    if (!turns.length) return this.table.replaceChildren(make("p", { textContent: say("turning_none") }));
    const head = ["turn_time", "turn_coordinate", "turn_value"].map((name) => make("th", { scope: "col", textContent: say(name) }));
    const row = ([time, place, value]) =>
      make("tr", {}, make("td", { textContent: time }), make("td", { innerHTML: symbols[place] }), make("td", { innerHTML: value }));
    const caption = make("caption", { className: "visually-hidden", textContent: say("turning_points") });
    this.table.replaceChildren(
      make("table", {}, caption, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...turns.map(row))),
    );
  }

  /** Shows a picture. */
  turnTo(at) {
    const { frames, seconds } = this.film;
    this.at = at;
    const place = Math.floor(at);
    this.screen.querySelector(".moving").innerHTML = frames[place];
    this.time.value = place;
    this.time.setAttribute("aria-valuetext", `${((seconds * place) / (frames.length - 1)).toPrecision(3)} s`);
    this.now.setAttribute("d", `M${(600 * place) / (frames.length - 1)} 0V120`);
  }

  start() {
    this.isPlaying = true;
    this.play.textContent = say("pause");
    if (this.at >= this.film.frames.length - 1) this.turnTo(0);
    let before = performance.now();
    const tick = (now) => {
      if (!this.isPlaying || !this.root.isConnected) return;
      const { length } = this.film.frames;
      const at = this.at + ((now - before) * RATE * (this.isSlow ? 0.25 : 1)) / 1000;
      before = now;
      // Modes and steady motions begin again where they end.
      const isEndless = this.film.runs[this.run][0] !== "start";
      if (at >= length - 1 && !isEndless) {
        this.turnTo(length - 1);
        return this.stop();
      }
      this.turnTo(Math.max(0, at % (length - 1)));
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  stop() {
    this.isPlaying = false;
    this.play.textContent = say("play");
  }
}

// ── Beginning ──────────────────────────────────────────────────────────────────────────────────

async function begin() {
  if (!globalThis.DecompressionStream || !globalThis.WebAssembly) {
    element("stage").textContent = say("too_old");
    return;
  }
  const code = unpacked("grader").then((bytes) => WebAssembly.compile(joined(bytes)));
  document.fonts.add(new FontFace("Vibank Math", carried("font")));
  const items = await unpacked("items");
  const first = new TextDecoder().decode(items.subarray(0, items.indexOf(10)));
  const practice = JSON.parse(first);
  const grader = new Grader(code, items);
  await grader.start();
  const about = element("course");
  const course = about ? new Course(JSON.parse(about.textContent), practice, grader) : undefined;
  globalThis.page = new Page(practice, grader, course ?? new Memory(practice.title), course);
  document.documentElement.dataset.ready = Math.round(performance.now());
}

begin().catch((error) => {
  console.error(error);
  element("stage").textContent = say("failed");
});
