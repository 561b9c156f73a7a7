// Drives what a teacher may ask of a SCORM package: few attempts, no solutions, a package that is made anew, too much of it.
//
//   cd tests/page && npm install
//   node rules.mjs VIBANK [BROWSER]        BROWSER: /usr/bin/chromium if left out
//
// VIBANK is the program; packages are made here, of the bank that comes with it and of a copy with one item changed.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Platform, answer, ask, leave, open, part, refused, step } from "./platform.mjs";

const [vibank, executablePath = "/usr/bin/chromium"] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), "rules-"));
process.on("exit", () => rmSync(scratch, { recursive: true }));
const LEARNER = "4711";
const ITEM = "ch3/t8-two-time-constants";
const complaints = [];

function run(...words) {
  const ran = spawnSync(vibank, words, { encoding: "utf8" });
  return { status: ran.status, said: ran.stdout + ran.stderr };
}

let count = 0;
/** A package with these rules; `further` stands behind its first question. */
function packed(version, rules, { item = ITEM, further = "", bank = [] } = {}) {
  const blueprint = join(scratch, "rules.toml");
  writeFileSync(blueprint, `title = "Rules"\nseed = 1\nvariants = 1\n[page]\nid = "rules"\n${rules}\n[[question]]\nitem = "${item}"\n${further}`);
  const file = join(scratch, `${(count += 1)}.zip`);
  const ran = run("page", "--scorm", version, blueprint, "--out", file, ...bank);
  return { file, ...ran };
}

/** A package on a platform, and the keys of the learner by letter. */
async function begin(version, rules, more) {
  const { file, status, said } = packed(version, rules, more);
  assert.equal(status, 0, said);
  const platform = await Platform.start(file, executablePath);
  return { platform, keys: keys(file, more?.bank) };
}

function keys(file, bank = []) {
  const { said } = run("show", "--learner", LEARNER, "--key", file, ...bank);
  const found = {};
  let letter;
  for (const line of said.split("\n")) {
    letter = line.match(/^([a-z]+\d*)\) /)?.[1] ?? letter;
    found[letter] ??= line.match(/^ {3}= (.*)$/)?.[1];
  }
  return found;
}

async function end(platform) {
  complaints.push(...platform.complaints);
  await platform.stop();
}

const note = ({ frame }) => frame.locator("#course-note").textContent();
const said = (frame, letter) => part(frame, letter).locator(".feedback").textContent();
const credit = (frame, letter) => frame.evaluate((letter) => {
  const { part, record } = globalThis.page.stage.parts.find(({ part }) => part.letter === letter);
  return record.attempts === undefined ? part : record;
}, letter);
const isOver = async (frame, letter) => {
  const button = part(frame, letter).locator("button[type=submit]");
  const inputs = part(frame, letter).locator(".answer input:enabled, .answer button:enabled");
  return (await button.isDisabled()) && (await inputs.count()) === 0;
};

for (const version of ["1.2", "2004"]) {
  await step(`${version}: attempts are counted, end, and are back in a fresh profile`, async () => {
    const { platform, keys } = await begin(version, "attempts = 2\npass = \"90 %\"");
    const sitting = await platform.sit(LEARNER);
    const { frame } = sitting;
    assert.match(await note(sitting), /Attempts for each part: 2/);
    await open(frame, 0);
    await answer(frame, "c", "x + * )");
    assert.match(await said(frame, "c"), /Not readable, no attempt spent/);
    assert.equal((await credit(frame, "c")).attempts, 0);
    await answer(frame, "c", "9999999");
    assert.equal(await isOver(frame, "c"), false);
    await answer(frame, "c", "8888888");
    assert.equal((await credit(frame, "c")).attempts, 2);
    assert.ok(await isOver(frame, "c"), "no third attempt");
    await answer(frame, "d", "9999999");
    await answer(frame, "d", keys.d);
    assert.match(await said(frame, "d"), /Right/);
    assert.ok(await isOver(frame, "d"));
    const before = [await frame.evaluate(() => globalThis.page.course.result().share)];
    // Who asks the grader of the page behind its back has no attempt more: what counts is what the page reports.
    assert.deepEqual(await refused(sitting), []);
    await leave(sitting);
    assert.equal(platform.interactions(LEARNER).length, 4, "each attempt is journalled, what was not read is not");
    assert.equal(platform.score(LEARNER), Math.round(1e4 * before[0]) / 100);
    const again = await platform.sit(LEARNER);
    await open(again.frame, 0);
    assert.ok(await isOver(again.frame, "c"), "in a fresh profile, too");
    assert.ok(await isOver(again.frame, "d"));
    assert.equal(await isOver(again.frame, "e"), false);
    assert.equal(await again.frame.evaluate(() => globalThis.page.course.result().share), before[0]);
    assert.deepEqual(await refused(again), []);
    await leave(again);
    assert.equal(platform.interactions(LEARNER).length, 4);
    const other = await platform.sit("4712");
    await open(other.frame, 0);
    assert.equal(await isOver(other.frame, "c"), false, "another learner has attempts of their own");
    await leave(other);
    await end(platform);
    return `${platform.score(LEARNER)} %, ${platform.status(LEARNER)}`;
  });

  await step(`${version}: a solution seen freezes the credit of its question`, async () => {
    const { platform, keys } = await begin(version, "");
    const sitting = await platform.sit(LEARNER);
    const { frame } = sitting;
    await open(frame, 0);
    const solve = (letter) => part(frame, letter).getByRole("button", { name: "Show solution" });
    assert.equal(await solve("c").count(), 0, "not before an answer");
    await answer(frame, "c", keys.c);
    const { share } = await frame.evaluate(() => globalThis.page.course.result());
    assert.ok(share > 0);
    await solve("c").click();
    // The grader answers when it has time.
    await part(frame, "c").locator(".solution").filter({ hasText: /\S/ }).waitFor();
    await answer(frame, "d", keys.d);
    assert.equal((await frame.evaluate(() => globalThis.page.course.result())).share, share, "nothing is added");
    await leave(sitting);
    assert.equal(platform.score(LEARNER), Math.round(1e4 * share) / 100);
    const again = await platform.sit(LEARNER);
    await open(again.frame, 0);
    await answer(again.frame, "e", keys.e);
    assert.equal((await again.frame.evaluate(() => globalThis.page.course.result())).share, share, "nor after coming back");
    await leave(again);
    await end(platform);
  });

  await step(`${version}: without solutions none can be asked for, and none is in the package`, async () => {
    const { platform, keys } = await begin(version, 'solution = "never"');
    const sitting = await platform.sit(LEARNER);
    const { frame } = sitting;
    await open(frame, 0);
    const code = await frame.evaluate(() => globalThis.page.stage.record.code);
    const parts = await frame.evaluate(() => globalThis.page.stage.parts.map(({ part }) => part));
    await answer(frame, "c", "9999999");
    await answer(frame, "d", keys.d);
    assert.equal(await frame.getByRole("button", { name: "Show solution" }).count(), 0);
    for (const { id } of parts) {
      const { html } = await ask(frame, { do: "solve", question: 0, code, part: id });
      assert.equal((html ?? "").replace(/<[^>]*>/g, "").trim(), "", `the worked solution of ${id} is not there to be asked for`);
    }
    await leave(sitting);
    await end(platform);
    const open_ = await begin(version, "");
    const other = await open_.platform.sit(LEARNER);
    await open(other.frame, 0);
    const texts = [];
    for (const { id } of parts) texts.push((await ask(other.frame, { do: "solve", question: 0, code, part: id })).html ?? "");
    assert.ok(texts.some((text) => /add up|both rates|two real roots/.test(text)), "with solutions it is");
    await other.page.goto("about:blank");
    await end(open_.platform);
  });

  await step(`${version}: a package made anew goes on with old answers where its items are the same`, async () => {
    const { platform, keys: own } = await begin(version, "");
    const first = await platform.sit(LEARNER);
    await open(first.frame, 0);
    await answer(first.frame, "c", own.c);
    await answer(first.frame, "d", "9999999");
    await leave(first);
    const score = platform.score(LEARNER);
    assert.ok(score > 0);
    // Other rules, the same questions.
    platform.upload(packed(version, "attempts = 3\npass = \"95 %\"").file);
    const second = await platform.sit(LEARNER);
    await open(second.frame, 0);
    assert.equal((await credit(second.frame, "c")).response, own.c);
    assert.equal((await credit(second.frame, "c")).credit, 1);
    assert.equal((await credit(second.frame, "d")).attempts, 1);
    assert.ok(!/have changed/.test(await note(second)));
    assert.deepEqual(await refused(second), []);
    await leave(second);
    assert.equal(platform.score(LEARNER), score);
    await end(platform);
  });

  await step(`${version}: where an item has changed, learners are informed, begin anew and keep their score`, async () => {
    const { platform, keys: own } = await begin(version, "");
    const first = await platform.sit(LEARNER);
    await open(first.frame, 0);
    for (const letter of ["c", "d"]) await answer(first.frame, letter, own[letter]);
    await leave(first);
    const score = platform.score(LEARNER);
    const folder = join(scratch, `bank-${version}`);
    cpSync(fileURLToPath(new URL("../../bank", import.meta.url)), folder, { recursive: true });
    const item = join(folder, `${ITEM}.toml`);
    writeFileSync(item, `# An edition with another first line.\n${readFileSync(item, "utf8")}`);
    const made = packed(version, "", { bank: ["--bank", folder, "--no-index"] });
    assert.equal(made.status, 0, made.said);
    platform.upload(made.file);
    const now = keys(made.file, ["--bank", folder, "--no-index"]);
    const second = await platform.sit(LEARNER);
    const { frame } = second;
    assert.match(await note(second), new RegExp(`have changed .*keep your score of ${score} %`));
    await open(frame, 0);
    assert.equal((await credit(frame, "c")).attempts, 0);
    await answer(frame, "c", now.c);
    assert.deepEqual(await refused(second), []);
    await leave(second);
    assert.equal(platform.score(LEARNER), score, "less than before lowers nothing");
    const third = await platform.sit(LEARNER);
    await open(third.frame, 0);
    assert.equal((await credit(third.frame, "c")).credit, 1, "from now on the new answers are back");
    for (const letter of ["a", "b", "d", "e"]) await answer(third.frame, letter, now[letter]);
    await leave(third);
    assert.ok(platform.score(LEARNER) > score, `${platform.score(LEARNER)} after ${score}`);
    await end(platform);
    return `${score} %, then ${platform.score(LEARNER)} %`;
  });

  await step(`${version}: opening and leaving by turns, a network that is lost and found, two closes each time`, async () => {
    const { platform, keys } = await begin(version, "attempts = 6");
    const { context } = await platform.sit("4799");
    for (let turn = 0; turn < 4; turn += 1) {
      platform.isDown = turn % 2 === 1;
      const sitting = await platform.sit(LEARNER, context);
      await open(sitting.frame, 0);
      await answer(sitting.frame, "c", turn === 3 ? keys.c : `${9_000_000 + turn}`);
      const { ends } = await leave(sitting);
      assert.equal(ends.length, 1);
    }
    platform.isDown = false;
    const last = await platform.sit(LEARNER, context);
    await open(last.frame, 0);
    assert.equal((await credit(last.frame, "c")).attempts, 4, "no attempt is lost or counted twice");
    assert.deepEqual(await refused(last), []);
    await leave(last);
    const ids = platform.interactions(LEARNER).map(({ id }) => id);
    assert.equal(new Set(ids).size, 4);
    assert.equal(ids.length, 4);
    assert.ok(platform.score(LEARNER) > 0);
    await end(platform);
  });
}

await step("an item that is asked twice, with other data, is two questions", async () => {
  const twice = `set = { m = "1 kg" }\n[[question]]\nitem = "${ITEM}"\nset = { m = "2 kg" }\n`;
  const { platform } = await begin("2004", "", { further: twice });
  const sitting = await platform.sit(LEARNER);
  const { frame } = sitting;
  await open(frame, 0);
  await answer(frame, "c", "9999999");
  await open(frame, 1);
  assert.equal((await credit(frame, "c")).attempts, 0, "the other one is untouched");
  assert.equal(await part(frame, "c").locator(".line input[type=text]").inputValue(), "");
  await answer(frame, "c", "8888888");
  await leave(sitting);
  const again = await platform.sit(LEARNER);
  for (const [number, typed] of ["9999999", "8888888"].entries()) {
    await open(again.frame, number);
    assert.equal((await credit(again.frame, "c")).response, typed);
  }
  await leave(again);
  await end(platform);
});

await step("a package whose state could be too long is refused with the numbers and the ways out", () => {
  // One item many times, with data that are fixed: each is a question with a state of its own.
  const question = (at) => `[[question]]\nitem = "ch2/p3-parallel-springs-damper"\nset = { m = "${(2 + at / 1000).toFixed(3)} kg" }\n`;
  const further = Array.from({ length: 198 }, (_, at) => question(at)).join("");
  const { status, said } = packed("1.2", "", { further });
  assert.equal(status, 2, said);
  assert.match(said, /4,?096/);
  assert.match(said, /fewer questions.*2004/);
  return said.trim().split("\n").join("; ");
});

assert.deepEqual(complaints, [], "the console is empty");
console.log("ok  the console is empty");
