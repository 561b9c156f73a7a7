// The page in a course: what was done goes to a platform by SCORM 1.2 or SCORM 2004, and comes back from it.
// It comes before the script of the page, which asks `Course` where there is one.

// ── The platform ───────────────────────────────────────────────────────────────────────────────

/** What the two versions call the same things. */
const DIALECTS = {
  "1.2": {
    api: "API",
    calls: { start: "LMSInitialize", get: "LMSGetValue", set: "LMSSetValue", save: "LMSCommit", end: "LMSFinish", error: "LMSGetLastError" },
    learner: "cmi.core.student_id",
    mode: "cmi.core.lesson_mode",
    entry: "cmi.core.entry",
    exit: "cmi.core.exit",
    time: "cmi.core.session_time",
    score: "cmi.core.score",
    response: "student_response",
    longest: 255,
    wrong: "wrong",
    moment: ["time", () => new Date().toTimeString().slice(0, 8)],
    span: (seconds) => [seconds / 3600, (seconds / 60) % 60, seconds % 60].map((of) => String(Math.floor(of)).padStart(2, "0")).join(":"),
  },
  2004: {
    api: "API_1484_11",
    calls: { start: "Initialize", get: "GetValue", set: "SetValue", save: "Commit", end: "Terminate", error: "GetLastError" },
    learner: "cmi.learner_id",
    mode: "cmi.mode",
    entry: "cmi.entry",
    exit: "cmi.exit",
    time: "cmi.session_time",
    score: "cmi.score",
    response: "learner_response",
    longest: 250,
    wrong: "incorrect",
    // A zone may follow fractions of seconds only.
    moment: ["timestamp", () => `${new Date().toISOString().slice(0, 21)}Z`],
    span: (seconds) => `PT${Math.floor(seconds)}S`,
  },
};

class Platform {
  constructor(dialect, api) {
    Object.assign(this, { dialect, api });
  }

  /** The platform that is found up the frames or up those of the window that opened this one, if there is any. */
  static find(dialect) {
    const up = (window) => {
      for (let level = 0; window && level < 50; level += 1) {
        if (window[dialect.api]) return window[dialect.api];
        if (window.parent === window) return null;
        window = window.parent;
      }
      return null;
    };
    for (const begin of [() => window, () => top.opener]) {
      try {
        const api = up(begin());
        if (api) return new Platform(dialect, api);
      } catch {
        // A frame of somebody else.
      }
    }
    return null;
  }

  call(what, ...values) {
    try {
      return String(this.api[this.dialect.calls[what]](...values));
    } catch (error) {
      console.warn(error);
      return "false";
    }
  }

  get(element) {
    const value = this.call("get", element);
    return value === "false" || value === "null" || value === "undefined" ? "" : value;
  }

  set(element, value) {
    if (this.call("set", element, String(value)) === "true") return;
    console.warn(`${element}: ${this.call("error")}`);
  }
}

// ── State ──────────────────────────────────────────────────────────────────────────────────────

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
const number = (value, places) => Array.from({ length: places }, (_, at) => DIGITS[(value >> (6 * at)) & 63]).join("");
const value = (text) => [...text].reduceRight((sum, digit) => sum * 64 + DIGITS.indexOf(digit), 0);

/** Words in seven bits: what is not printable there is written by its code. */
const plain = (text) => text.replace(/\\/g, "\\\\").replace(/[^ -~]/gu, (sign) => `\\${sign.codePointAt(0).toString(16)};`);
const worded = (text) => text.replace(/\\(\\|([0-9a-f]+);)/g, (_, all, code) => (code ? String.fromCodePoint(parseInt(code, 16)) : "\\"));

const VERDICTS = [undefined, "right", "partial", "wrong"];
/** Credit is kept in parts of 2520, the least common multiple of 1 to 10. */
const WHOLE = 2520;
/** Longer answers are not kept. */
const LONGEST_TEXT = 300;

/**
 * What was done, as one line of printable ASCII: `v1`, digest (8), submitted or with a score (1), changes (3), question (2), then four
 * digits a part: credit (12 bits), verdict (2), attempts (6), hints (3), solution seen (1). Behind it typed texts, the
 * newest first, up to the room that is left: part (2), length (2), text.
 */
class State {
  constructor(course, keys) {
    Object.assign(this, { course, keys });
    this.places = course.questions.flatMap(({ parts }, question) => parts.map(({ id }) => ({ question, id })));
  }

  pack(memory) {
    const records = this.places.map(({ question, id }) => memory.questions[this.keys[question]]?.parts[id]);
    const current = Math.max(0, this.keys.indexOf(memory.current));
    let out = `v1${this.course.digest}${memory.submitted ? "s" : memory.hasScore ? "r" : "-"}${number(memory.changes, 3)}${number(current, 2)}`;
    for (const record of records) {
      const { credit = 0, verdict, attempts = 0, hints = 0, solved } = record ?? {};
      const low = Math.round(credit * WHOLE);
      const high = Math.max(0, VERDICTS.indexOf(verdict)) | (Math.min(attempts, 63) << 2) | (Math.min(hints, 7) << 8) | (solved ? 1 << 11 : 0);
      out += number(low, 2) + number(high, 2);
    }
    const typed = records.map((record, at) => ({ at, record })).filter(({ record }) => record?.response);
    typed.sort((a, b) => (b.record.at ?? 0) - (a.record.at ?? 0));
    for (const { at, record } of typed) {
      const text = plain(record.response);
      if (text.length > LONGEST_TEXT || out.length + 4 + text.length > this.course.room) continue;
      out += number(at, 2) + number(text.length, 2) + text;
    }
    return out;
  }

  static changes(text) {
    return text.startsWith("v1") ? value(text.slice(11, 14)) : 0;
  }

  /** Whether a state belongs to these questions. */
  fits(text) {
    return text.startsWith(`v1${this.course.digest}`) && text.length >= 16 + 4 * this.places.length;
  }

  unpack(text, memory) {
    memory.submitted = text[10] === "s";
    memory.hasScore = text[10] !== "-";
    memory.changes = State.changes(text);
    memory.current = this.keys[value(text.slice(14, 16))] ?? "";
    const records = this.places.map(({ question, id }, at) => {
      const digits = text.slice(16 + 4 * at, 20 + 4 * at);
      const [low, high] = [value(digits.slice(0, 2)), value(digits.slice(2))];
      if (low === 0 && high === 0) return (memory.question(this.keys[question]).parts[id] = { response: "", attempts: 0, hints: 0 });
      const record = { response: "", credit: low / WHOLE, attempts: (high >> 2) & 63, hints: (high >> 8) & 7 };
      if (VERDICTS[high & 3]) record.verdict = VERDICTS[high & 3];
      if (high >> 11) record.solved = true;
      memory.question(this.keys[question]).parts[id] = record;
      return record;
    });
    let at = 16 + 4 * this.places.length;
    for (let age = 0; at + 4 <= text.length; age += 1) {
      const length = value(text.slice(at + 2, at + 4));
      const record = records[value(text.slice(at, at + 2))];
      // Older texts have smaller numbers, as they had before.
      if (record) Object.assign(record, { response: worded(text.slice(at + 4, at + 4 + length)), at: -age });
      at += 4 + length;
    }
  }
}

// ── The course ─────────────────────────────────────────────────────────────────────────────────

/** Statuses of SCORM, from least to most: what was reached stays. */
const RANKS = ["", "unknown", "not attempted", "incomplete", "failed", "completed", "passed"];

class Course {
  constructor(about, practice, grader) {
    Object.assign(this, { about, practice, grader, changes: 0, submitted: false, questions: {}, current: "" });
    this.keys = practice.questions.map(keyOf);
    this.state = new State(about, this.keys);
    this.rules = { ...about, isSilent: about.feedback !== "at once" };
    this.pending = [];
    this.kept = 0;
    this.begun = Date.now();
    this.dialect = DIALECTS[about.version];
    this.platform = Platform.find(this.dialect);
    if (!this.platform || this.platform.call("start", "") !== "true") {
      this.platform = null;
      // On its own it is a page as any other, which keeps what was done in this browser.
      const memory = new Memory(practice.title);
      Object.assign(this, { questions: memory.questions, current: memory.current, submitted: memory.submitted });
      this.memory = memory;
      return this.tell("course_alone");
    }
    this.open();
  }

  open() {
    const { platform, dialect } = this;
    this.learner = platform.get(dialect.learner);
    const mode = platform.get(dialect.mode) || "normal";
    this.reports = this.learner !== "" && mode === "normal";
    this.isPinned = this.learner !== "";
    this.restore(platform.get(dialect.entry));
    if (!this.reports) return this.tell(mode === "normal" ? "course_nobody" : "course_review");
    this.tell(this.reached);
    this.raise("incomplete");
    platform.set(dialect.exit, "suspend");
    if (this.pending.length > 0) {
      this.pending.forEach((entry) => this.journal(entry));
      this.report();
    }
    this.save();
    addEventListener("pagehide", () => this.close());
    // A page that comes back from the store of the browser has no platform any more.
    addEventListener("pageshow", ({ persisted }) => persisted && location.reload());
    addEventListener("online", () => this.save());
    document.addEventListener("visibilitychange", () => document.hidden && this.save());
  }

  /** The state of the platform, or that of this browser, where the platform could not be reached last. */
  restore(entry) {
    const { platform, dialect } = this;
    const stored = entry === "ab-initio" ? "" : platform.get("cmi.suspend_data");
    // A score that was never set may not be asked for.
    if (/^v1.{8}[rs]/.test(stored)) this.kept = Number(platform.get(`${dialect.score}.raw`)) || 0;
    const own = this.reports ? this.local() : null;
    const isNewer = own && this.state.fits(own.state) && State.changes(own.state) > State.changes(stored);
    const state = isNewer ? own.state : stored;
    if (isNewer) this.pending = own.pending.filter(({ change }) => change > State.changes(stored));
    if (this.state.fits(state)) this.state.unpack(state, this);
    else if (state.startsWith("v1")) this.isOther = true;
    this.keys.forEach((key, question) => {
      if (this.questions[key]) this.questions[key].status = this.status(question);
    });
  }

  status(question) {
    const records = this.asked(question).map(({ id }) => this.questions[this.keys[question]].parts[id]);
    if (!records.some((record) => record?.attempts > 0 || record?.solved)) return "new";
    if (this.rules.isSilent) return "tried";
    if (records.some((record) => record?.solved)) return "seen";
    return records.every((record) => record?.credit === 1) ? "done" : "tried";
  }

  /** The store of this browser for this package and this learner; no other is looked at. */
  get store() {
    return `vibank course ${this.about.id} ${this.learner}`;
  }

  local() {
    try {
      return JSON.parse(localStorage.getItem(this.store));
    } catch {
      return null;
    }
  }

  /** What is said where the platform can be reached. */
  get reached() {
    return this.rules.isSilent && !this.submitted ? "course_waits" : "course_reports";
  }

  /** Says how it stands with the platform. */
  tell(key, values = {}) {
    const words = [say(key, values)];
    if (this.isOther) words.push(say("course_other", { score: this.kept }));
    if (this.rules.attempts && !this.rules.isSilent) words.push(say("course_attempts", { count: this.rules.attempts }));
    element("course-note").textContent = words.join(" ");
    this.told = key;
  }

  /** The number from which this learner's variant is looked for; the same as `first_variant` of the command line. */
  from(question) {
    const { about, learner, keys } = this;
    const mix = (hash, shift, factor) => BigInt.asUintN(64, (hash ^ (hash >> shift)) * factor);
    let hash = 0xcbf29ce484222325n;
    for (const byte of new TextEncoder().encode(`${about.id}\n${keys[question]}\n${learner}`)) {
      hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    }
    hash = mix(mix(hash, 30n, 0xbf58476d1ce4e5b9n), 27n, 0x94d049bb133111ebn);
    return Number((hash ^ (hash >> 31n)) >> 24n);
  }

  /** The parts of a question that are asked of this learner, and what they are worth. */
  asked(question) {
    this.known ??= [];
    return (this.known[question] ??= this.findAsked(question));
  }

  findAsked(question) {
    const { parts } = this.about.questions[question];
    if (!parts.some(({ varies }) => varies)) return parts;
    const code = this.question(this.keys[question]).code || this.grader.ask({ do: "choose", question, from: this.from(question) }).code;
    const shown = this.grader.ask({ do: "show", question, code }).parts ?? [];
    const asked = parts.filter(({ id }) => shown.some((part) => part.id === id));
    // A question is worth the same whatever is asked of it.
    const sum = (of) => of.reduce((all, { points }) => all + points, 0);
    return asked.map((part) => ({ ...part, points: (part.points * sum(parts)) / sum(asked) }));
  }

  /** The share of the points that was reached, and of the parts that were answered. */
  result() {
    let [got, all, answered, count] = [0, 0, 0, 0];
    this.keys.forEach((key, question) => {
      for (const { id, points } of this.asked(question)) {
        const { credit = 0, attempts = 0 } = this.questions[key]?.parts[id] ?? {};
        got += points * credit;
        all += points;
        answered += attempts > 0;
        count += 1;
      }
    });
    return { share: all > 0 ? got / all : 0, answered: count > 0 ? answered / count : 0 };
  }

  // What the page asks of a memory.

  question(key) {
    return (this.questions[key] ??= { code: "", status: "new", parts: {} });
  }

  keep() {
    if (!this.memory) return;
    Object.assign(this.memory, { questions: this.questions, current: this.current, submitted: this.submitted });
    this.memory.keep();
  }

  forget() {
    Object.assign(this, { questions: {}, submitted: false });
    this.memory?.forget();
  }

  // What the page says has happened.

  /** An answer was marked. */
  marked(question, part, record) {
    record.at = Date.now();
    this.changed();
    if (this.rules.isSilent && !this.submitted) return this.save();
    this.journal(this.entry(question, part, record, record.markedCredit ?? 0));
    this.report();
    this.save();
  }

  /** A hint or a solution was seen. */
  seen() {
    this.changed();
    this.save();
  }

  changed() {
    this.changes = Math.min(this.changes + 1, 0x3ffff);
  }

  /** All answers are handed in: from now on they stay as they are. */
  submit() {
    this.submitted = true;
    this.changed();
    this.practice.questions.forEach((_, question) => {
      for (const { id } of this.asked(question)) {
        const record = this.questions[this.keys[question]]?.parts[id];
        if (record?.attempts > 0) this.journal(this.entry(question, id, record, record.credit ?? 0));
      }
    });
    this.report();
    this.keep();
    if (this.reports) this.tell(this.reached);
    this.save();
  }

  entry(question, part, record, credit) {
    const code = this.questions[this.keys[question]].code || this.grader.ask({ do: "choose", question, from: this.from(question) }).code;
    const { item } = this.practice.questions[question];
    return {
      change: this.changes,
      id: [item.replace("/", "."), part, code, record.attempts].join("."),
      response: record.response,
      credit,
    };
  }

  journal(entry) {
    if (!this.reports) return;
    const { platform, dialect } = this;
    if (!this.pending.includes(entry)) this.pending.push(entry);
    this.next ??= Number(platform.get("cmi.interactions._count")) || 0;
    const set = (name, value) => platform.set(`cmi.interactions.${this.next}.${name}`, value);
    const results = { 0: dialect.wrong, 1: "correct" };
    // A brace would begin the name of a language.
    const response = entry.response.replace(/^\{/, " {").slice(0, dialect.longest);
    set("id", entry.id);
    set("type", "fill-in");
    set(dialect.moment[0], dialect.moment[1]());
    set(dialect.response, response);
    set("result", results[entry.credit] ?? String(Math.round(entry.credit * 1e4) / 1e4));
    this.next += 1;
  }

  /** Score and status, neither of them below what was reached. */
  report() {
    if (!this.reports) return;
    const { platform, dialect, rules } = this;
    const { share, answered } = this.result();
    const percent = Math.max(this.kept, Math.round(share * 1e4) / 100);
    this.kept = percent;
    this.hasScore = true;
    const score = { min: 0, max: 100, raw: percent };
    if (this.about.version === "2004") score.scaled = Math.round(percent * 100) / 1e4;
    for (const [name, value] of Object.entries(score)) platform.set(`${dialect.score}.${name}`, value);
    const isDone = this.submitted || (!rules.isSilent && answered >= 1);
    if (this.about.version === "2004") platform.set("cmi.progress_measure", Math.round(answered * 1e4) / 1e4);
    const isPassed = rules.pass && percent >= 100 * rules.pass - 1e-9;
    if (isPassed) this.raise("passed");
    if (isDone) this.raise(rules.pass ? (isPassed ? "passed" : "failed") : "completed", "completed");
  }

  /** Raises the status; SCORM 2004 keeps completion and success apart. */
  raise(status, completion = status) {
    const { platform } = this;
    const raise = (element, to) => {
      if (RANKS.indexOf(to) > RANKS.indexOf(platform.get(element))) platform.set(element, to);
    };
    if (this.about.version === "1.2") return raise("cmi.core.lesson_status", status);
    if (["incomplete", "completed"].includes(completion)) raise("cmi.completion_status", completion);
    if (["passed", "failed"].includes(status)) raise("cmi.success_status", status);
  }

  /** Hands everything to the platform; until that has worked, this browser keeps it too. */
  save() {
    if (!this.reports || this.isClosed) return;
    clearTimeout(this.waiting);
    const state = this.state.pack(this);
    const { platform } = this;
    try {
      localStorage.setItem(this.store, JSON.stringify({ state, pending: this.pending }));
    } catch {
      // Without a store of its own, a page relies on the platform.
    }
    platform.set("cmi.suspend_data", state);
    if (platform.call("save", "") === "true") {
      this.pending = [];
      this.delay = undefined;
      try {
        localStorage.removeItem(this.store);
      } catch {
        // There is none.
      }
      if (this.told === "course_unsaved") this.tell(this.reached);
      return;
    }
    this.delay = Math.min(60, 2 * (this.delay ?? 2.5));
    this.tell("course_unsaved");
    this.waiting = setTimeout(() => this.save(), 1000 * this.delay);
  }

  /** The page is left: once, whatever the browser calls it. */
  close() {
    if (this.isClosed) return;
    const { platform, dialect } = this;
    platform.set(dialect.time, dialect.span((Date.now() - this.begun) / 1000));
    platform.set(dialect.exit, "suspend");
    this.save();
    this.isClosed = true;
    clearTimeout(this.waiting);
    platform.call("end", "");
  }
}

