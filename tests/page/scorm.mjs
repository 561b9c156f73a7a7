// Drives a SCORM package in a real browser, on a platform that is scorm-again.
//
//   cd tests/page && npm install
//   node scorm.mjs PACKAGE.zip KEYS.txt [BROWSER]        BROWSER: /usr/bin/chromium if left out
//
// PACKAGE.zip is made by `vibank page --scorm 1.2|2004 scorm.toml --out PACKAGE.zip`, KEYS.txt by
// `vibank show --learner 4711 --key PACKAGE.zip >KEYS.txt`. Pictures go to `shots/`. Exit code 0: everything held.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { Platform, answer, ask, calls, leave, open, part, refused, step, type, wide } from "./platform.mjs";

const [file, keysFile, executablePath = "/usr/bin/chromium"] = process.argv.slice(2);
const LEARNER = "4711";
const platform = await Platform.start(file, executablePath);
const { about, isOld, browser, address, complaints } = platform;
assert.match(platform.manifest, isOld ? /<schemaversion>1\.2</ : /<schemaversion>2004 4th Edition</);
mkdirSync("shots", { recursive: true });

const sit = (learner, context, viewport) => platform.sit(learner, context, viewport);
const cmi = (learner = LEARNER) => platform.cmi(learner);
const score = () => platform.score(LEARNER);
const status = () => platform.status(LEARNER);
const interactions = (learner = LEARNER) => platform.interactions(learner);
const known = (frame) => frame.evaluate(() => JSON.parse(JSON.stringify(globalThis.page.memory.questions)));

// ── What is typed ──────────────────────────────────────────────────────────────────────────────

/** Keys by question and letter, as the command line prints them for this learner. */
const keys = {};
{
  let [question, letter] = [null, null];
  for (const line of readFileSync(keysFile, "utf8").split("\n")) {
    const head = line.match(/^(ch\d+\/\S+)  ([0-9A-Z-]{11})$/);
    if (head) keys[(question = head[1])] = { code: head[2] };
    letter = line.match(/^([a-z]+\d*)\) /)?.[1] ?? letter;
    const key = line.match(/^ {3}= (.*)$/)?.[1];
    if (key) keys[question][letter] = key;
  }
}

/** Wrong answers of the form of a key. */
const spoiled = (key, kind) => ({
  numeric: ["9999999", ...(key.includes(";") ? [key.replace(/;.*/, "; 99 rad/s")] : [])],
  equation: [key.replace(/;.*/, ""), key.replaceAll("+", "−").replace("= 0", "= 1"), key.replace("−", "+")],
  interval: [key.replace("≥", "<")],
  matrix: [key.replaceAll("0", "m₁"), key.replaceAll("+", "−")],
  "mode-shape": ["[1.00, 9.9]"],
  function: ["t"],
  formula: ["9999999", `7 (${key})`],
})[kind] ?? ["9999999"];

/** What the answers are worth, summed here and not by the page. */
const points = { got: 0, all: 0, credits: {} };
const kinds = {};
const sent = [];

if (about.feedback !== "at once") {
  await submitting();
  await end();
}

await step("a first sitting: unreadable, wrong, partly right and right answers of all kinds", async () => {
  const sitting = await sit(LEARNER);
  const { frame } = sitting;
  assert.match(await frame.locator("#course-note").textContent(), /are reported/);
  assert.equal(await frame.getByRole("button", { name: "Another one like this" }).count(), 0, "data are pinned");
  for (const [number, { key, parts }] of about.questions.entries()) {
    await open(frame, number);
    const code = await frame.evaluate(() => globalThis.page.stage.record.code);
    assert.equal(code, keys[key].code, "the command line shows the data that the learner has");
    const shown = (await ask(frame, { do: "show", question: number, code })).parts;
    for (const { id, letter, kind, options } of shown) {
      const worth = (response) => {
        const earlier = Object.fromEntries(sent.filter((one) => one.key === key && one.id !== id).map((one) => [one.id, one.response]));
        return ask(frame, { do: "mark", question: number, code, part: id, response, earlier });
      };
      const letters = options.map((option) => option.letter);
      const typed = keys[key][letter];
      const candidates = letters.length ? letters : ["x + * )", ...spoiled(typed, kind), typed];
      // Of some parts the right answer stays away, so that the score is not the whole.
      const isLeft = kinds[kind]?.has("right") && !letters.length && (points.count ?? 0) % 3 === 0;
      const seen = new Set();
      for (const text of candidates.filter((text) => text && !(letters.length && text.includes(",")))) {
        const { verdict, credit } = await worth(text);
        if (seen.has(verdict) || verdict === "missing" || (isLeft && verdict === "right")) continue;
        seen.add(verdict);
        await answer(frame, letter, text);
        (kinds[kind] ??= new Set()).add(verdict);
        if (verdict === "unreadable") continue;
        points.credits[`${key} ${id}`] = Math.max(points.credits[`${key} ${id}`] ?? 0, credit);
        const place = sent.findIndex((one) => one.key === key && one.id === id);
        if (place >= 0) sent.splice(place, 1);
        sent.push({ key, id, response: text });
        points.count = (points.count ?? 0) + 1;
      }
    }
    for (const { id, points: worth } of parts) {
      points.got += worth * (points.credits[`${key} ${id}`] ?? 0);
      points.all += worth;
    }
  }
  const records = await known(frame);
  const kept = (name) => (([key, id]) => records[key]?.parts[id]?.credit ?? 0)(name.split(" "));
  const others = Object.entries(points.credits).filter(([name, credit]) => Math.abs(kept(name) - credit) > 1e-9);
  assert.deepEqual(others.map(([name, credit]) => [name, credit, records[name.split(" ")[0]]?.parts[name.split(" ")[1]]]), [], "each part has the credit of its best answer");
  points.share = points.got / points.all;
  assert.ok(points.share > 0.3 && points.share < 0.99, `${points.share}`);
  const stood = await frame.evaluate(() => globalThis.page.course.result());
  assert.ok(Math.abs(stood.share - points.share) < 1e-9, `${stood.share} and ${points.share}`);
  assert.equal(score(), Math.round(1e4 * points.share) / 100, "the score of the platform is the page's own");
  if (!isOld) assert.equal(Number(cmi().score.scaled), Math.round(1e4 * points.share) / 1e4);
  assert.deepEqual(await refused(sitting), [], "no call of the interface is refused");
  points.state = await known(frame);
  await frame.page().screenshot({ path: `shots/scorm-${about.version}.png` });
  const { ends } = await leave(sitting);
  assert.equal(ends.length, 1, "it is finished once");
  const wanted = ["integer", "equation", "choice", "formula", "numeric", "function", "interval", "matrix", "mode-shape"];
  assert.deepEqual(wanted.filter((kind) => !kinds[kind]?.has("right")), [], "each kind is right once");
  assert.deepEqual(wanted.filter((kind) => !kinds[kind]?.has("wrong")), [], "each kind is wrong once");
  const lists = Object.entries(kinds).map(([kind, verdicts]) => `${kind} (${[...verdicts].join(", ")})`);
  return `${lists.join("; ")}; ${score()} %`;
});

await step("what the platform keeps", () => {
  const ids = interactions().map(({ id }) => id);
  assert.equal(ids.length, points.count, "each answer that counts is journalled");
  assert.equal(new Set(ids).size, ids.length, "and once");
  assert.ok(interactions().every(({ type }) => type === "fill-in"));
  const longest = isOld ? 4096 : 64_000;
  assert.ok(cmi().suspend_data.length <= longest && /^[ -~]*$/.test(cmi().suspend_data));
  assert.ok(Object.values(kinds).some((verdicts) => verdicts.has("partial")));
  return `${ids.length} interactions, ${cmi().suspend_data.length} characters of state, ${status().join(" and ")}`;
});

await step("a second sitting in a fresh profile has all back, and lowers nothing", async () => {
  const before = [score(), status(), interactions().length];
  const sitting = await sit(LEARNER);
  const { frame } = sitting;
  for (const number of about.questions.keys()) await open(frame, number);
  const state = await known(frame);
  for (const [key, { parts }] of Object.entries(points.state)) {
    for (const [id, { response, verdict, credit, attempts }] of Object.entries(parts)) {
      const { response: text, verdict: said, credit: worth = 0, attempts: count } = state[key].parts[id];
      assert.deepEqual([text, said, count], [response, verdict, attempts], `${key} ${id}`);
      assert.ok(Math.abs(worth - (credit ?? 0)) < 1e-9, `${key} ${id}`);
    }
  }
  assert.deepEqual(await refused(sitting), []);
  await leave(sitting);
  assert.deepEqual([score(), status(), interactions().length], before);
});

await step("a lost network: kept here, said so, handed in later, nothing twice", async () => {
  const sitting = await sit("4712");
  await sitting.frame.waitForTimeout(50);
  platform.isDown = true;
  await open(sitting.frame, 0);
  const [{ letter, id }] = await sitting.frame.evaluate(() => globalThis.page.stage.parts.map(({ part }) => ({ letter: part.letter, id: part.id, options: part.options.length })).filter(({ options }) => !options));
  await answer(sitting.frame, letter, "1");
  assert.match(await sitting.frame.locator("#course-note").textContent(), /cannot be reached/);
  await leave(sitting);
  platform.isDown = false;
  const again = await sit("4712", sitting.context);
  const record = await again.frame.evaluate((id) => globalThis.page.memory.questions[globalThis.page.keys[0]].parts[id], id);
  assert.equal(record.response, "1");
  assert.equal(interactions("4712").length, 1);
  const stores = await again.frame.evaluate(() => Object.keys(localStorage));
  assert.deepEqual(stores, [], "what the platform has is not kept in this browser");
  // The network fails and comes back within one sitting.
  platform.isDown = true;
  await answer(again.frame, letter, "2");
  platform.isDown = false;
  await again.frame.evaluate(() => dispatchEvent(new Event("online")));
  await again.frame.waitForFunction(() => /are reported/.test(document.getElementById("course-note").textContent));
  assert.equal(interactions("4712").length, 2);
  await leave(again);
});

await step("another learner at the same computer sees nothing of it, and has other data", async () => {
  const first = await sit("4713");
  await open(first.frame, 0);
  const { letter } = await first.frame.evaluate(() => globalThis.page.stage.parts.find(({ part }) => !part.options.length).part);
  platform.isDown = true;
  await answer(first.frame, letter, "77");
  await leave(first);
  platform.isDown = false;
  const second = await sit("4714", first.context);
  await open(second.frame, 0);
  assert.equal(await part(second.frame, letter).locator("input[type=text]").first().inputValue(), "");
  const code = await second.frame.evaluate(() => globalThis.page.stage.record.code);
  assert.notEqual(code, keys[about.questions[0].key].code);
  await leave(second);
});

await step("review, browsing, and nobody: plays, reports nothing, says so", async () => {
  const commits = platform.commits;
  for (const [learner, mode, words] of [[LEARNER, "review", /review/], [LEARNER, "browse", /review/], ["nobody", "normal", /did not say who you are/]]) {
    platform.mode = mode;
    const sitting = await sit(learner);
    assert.match(await sitting.frame.locator("#course-note").textContent(), words);
    await open(sitting.frame, 0);
    const { letter } = await sitting.frame.evaluate(() => globalThis.page.stage.parts.find(({ part }) => !part.options.length).part);
    await answer(sitting.frame, letter, "3");
    assert.notEqual((await part(sitting.frame, letter).locator(".feedback").textContent()).trim(), "");
    const made = await calls(sitting);
    assert.deepEqual(made.filter(({ name }) => /SetValue|Commit/.test(name)), []);
    await sitting.page.goto("about:blank");
  }
  platform.mode = "normal";
  assert.equal(platform.commits, commits);
});

await step("without a platform it is a page as any other, and says so", async () => {
  const page = await (await browser.newContext()).newPage();
  const errors = [];
  page.on("console", (message) => message.type() === "error" && !/favicon|404/.test(message.text()) && errors.push(message.text()));
  await page.goto(`${address}/package/index.html`);
  await page.waitForSelector("html[data-ready]");
  assert.match(await page.locator("#course-note").textContent(), /not opened by a course/);
  assert.equal(await page.getByRole("button", { name: "Another one like this" }).count(), 1);
  assert.deepEqual(errors, [], "its security policy lets its program run");
});

await step("looks: phone", async () => {
  const sitting = await sit("4715", undefined, { width: 390, height: 844 });
  await sitting.page.screenshot({ path: `shots/scorm-${about.version}-phone.png` });
  assert.deepEqual(await wide(sitting.frame), [], "no sideways scrolling");
  await leave(sitting);
});

await end();

async function end() {
  await platform.stop();
  assert.deepEqual(complaints, [], "the console is empty");
  console.log("ok  the console is empty");
  process.exit(0);
}

/** A package that says nothing before all is submitted. */
async function submitting() {
  const typed = {};
  await step("answers are kept and changed, and nothing is said or reported", async () => {
    const sitting = await sit(LEARNER);
    const { frame } = sitting;
    await open(frame, 0);
    const { key } = about.questions[0];
    const shown = await frame.evaluate(() => globalThis.page.stage.parts.map(({ part }) => part));
    const lines = shown.filter(({ options }) => !options.length);
    for (const [at, { letter, id }] of lines.entries()) {
      await answer(frame, letter, "9999999");
      typed[id] = at === 0 ? "9999999" : keys[key][letter];
      // The last one is typed, and the button forgotten: it is handed in with the rest.
      if (at === lines.length - 1) {
        await type(frame, letter, typed[id]);
        continue;
      }
      await answer(frame, letter, typed[id]);
      assert.match(await part(frame, letter).locator(".feedback").textContent(), /Answer kept/);
      assert.equal(await part(frame, letter).getByRole("button", { name: "Show solution" }).count(), 0);
    }
    assert.match(await frame.locator("#score-words").textContent(), /answered$/);
    assert.deepEqual(await refused(sitting), []);
    await leave(sitting);
    assert.deepEqual(interactions(), []);
    assert.ok(Number.isNaN(score()) || score() === 0, `${score()}`);
  });
  await step("submitting reports all at once, and closes", async () => {
    const sitting = await sit(LEARNER);
    const { frame } = sitting;
    await open(frame, 0);
    const id = Object.keys(typed)[1];
    const { response } = await frame.evaluate((id) => globalThis.page.stage.record.parts[id], id);
    assert.equal(response, typed[id], "what was typed is back");
    await frame.getByRole("button", { name: "Submit all answers" }).click();
    await frame.getByRole("button", { name: "Submitted" }).waitFor();
    const { share } = await frame.evaluate(() => globalThis.page.course.result());
    assert.ok(share > 0 && share < 1);
    const { credit } = await frame.evaluate((id) => globalThis.page.stage.record.parts[id], Object.keys(typed).at(-1));
    assert.equal(credit, 1, "what was typed last counts, and not what was kept before it");
    assert.equal(await frame.locator(".part button[type=submit]:enabled").count(), 0, "nothing can be changed");
    const said = (await frame.locator(".feedback").allTextContents()).join(" ");
    if (about.feedback === "never") assert.ok(!/Right|not the answer/.test(said), said);
    else assert.ok(/Right/.test(said) && /not the answer/.test(said), said);
    assert.deepEqual(await refused(sitting), []);
    await leave(sitting);
    assert.equal(score(), Math.round(1e4 * share) / 100);
    assert.equal(interactions().length, Object.keys(typed).length);
    assert.equal(status()[0], isOld && about.pass ? "failed" : "completed");
    const again = await sit(LEARNER);
    assert.ok(await again.frame.getByRole("button", { name: "Submitted" }).isDisabled());
    await leave(again);
    assert.equal(interactions().length, Object.keys(typed).length, "and once");
    return `${score()} %, ${status()}`;
  });
}
