// Drives a self-check page in a real browser, opened from disk.
//
//   cd tests/page && npm install
//   node drive.mjs PAGE.html [BROWSER]        BROWSER: /usr/bin/chromium if left out
//
// PAGE.html is made by `vibank page --out PAGE.html` from the whole bank. Pictures go to `shots/`.
// Exit code 0: everything held. Every step prints one line; times are measured, not judged tightly.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { HtmlValidate } from "html-validate";
import { chromium } from "playwright-core";

const [file, executablePath = "/usr/bin/chromium"] = process.argv.slice(2);
const address = pathToFileURL(file).href;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
mkdirSync("shots", { recursive: true });

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, bypassCSP: true });
const page = await context.newPage();
const complaints = [];
page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
page.on("pageerror", (error) => complaints.push(String(error)));
page.on("request", (request) => {
  if (!/^(file|data|blob):/.test(request.url())) complaints.push(`fetches ${request.url()}`);
});

async function step(name, action) {
  const said = await action();
  console.log(`ok  ${name}${said === undefined ? "" : `: ${said}`}`);
}

const ready = () => page.waitForSelector("html[data-ready]");
const open = async (hash) => {
  await page.goto("about:blank");
  await page.goto(`${address}#${hash}`);
  await ready();
};
const part = (letter) => page.locator(`section[aria-labelledby=part-${letter}]`);
const field = (letter) => part(letter).locator("input[type=text]").first();
const feedback = (letter) => part(letter).locator(".feedback");
const answer = async (letter, text) => {
  await field(letter).fill(text);
  await part(letter).getByRole("button", { name: "Check" }).click();
};
/** Asks the grader of the page, as its own script does. */
const ask = (request) => page.evaluate((request) => globalThis.page.grader.ask(request), request);
/** The key of a part as somebody might type it. */
const key = async (letter) => {
  const value = part(letter).locator(".solution .value math").first();
  return (await value.getAttribute("alttext")) ?? "";
};
const check = async (name) => {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 120)}`);
  assert.deepEqual(found, [], name);
};

await step("size", () => {
  const size = statSync(file).size;
  assert.ok(size <= 1_800_000, `${size} bytes`);
  return `${size} bytes`;
});

await step("the file is valid HTML", async () => {
  const validator = new HtmlValidate({
    extends: ["html-validate:standard"],
    rules: { "long-title": "off", "no-inline-style": "off", "require-sri": "off" },
  });
  const report = await validator.validateString(readFileSync(file, "utf8"));
  const found = report.results.flatMap(({ messages }) => messages);
  assert.deepEqual(found.map(({ line, ruleId, message }) => `${line} ${ruleId}: ${message}`).slice(0, 10), []);
});

await step("opened from disk", async () => {
  await page.goto(address);
  await ready();
  const times = [];
  for (let run = 0; run < 5; run += 1) {
    await page.reload();
    await ready();
    times.push(Number(await page.locator("html").getAttribute("data-ready")));
  }
  return `a question can be answered after ${times.sort((a, b) => a - b)[2]} ms (median of ${times})`;
});

const FIRST = "ch3/e5-log-decrement";
const CODE = await (async () => {
  await open(FIRST);
  return (await page.locator(".identity b").textContent()).trim();
})();

await step("a link leads to the same data", async () => {
  const before = await page.locator(".statement").innerHTML();
  await open(`${FIRST}/${CODE}`);
  assert.equal(await page.locator(".statement").innerHTML(), before);
  assert.ok((await page.url()).endsWith(CODE));
});

await step("what cannot be read spends no attempt", async () => {
  await answer("a", "about twelve");
  assert.match(await feedback("a").textContent(), /Not readable/);
  assert.equal(await part("a").locator(".attempts").textContent(), "");
});

await step("letters and unit are put in at the caret, from the keyboard too", async () => {
  const bar = part("b").getByRole("toolbar");
  const buttons = bar.getByRole("button");
  const stops = await bar.locator("button[tabindex='0']").count();
  assert.equal(stops, 1, "one stop of the tab key");
  await field("b").fill("12");
  await field("b").press("Tab");
  const first = await page.evaluate(() => document.activeElement.getAttribute("aria-label"));
  assert.match(first, /^Insert /);
  if ((await buttons.count()) > 1) {
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), first);
    await page.keyboard.press("Home");
  }
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.tagName), "INPUT", "focus is back in the field");
  assert.notEqual(await field("b").inputValue(), "12");
  const described = (await field("b").getAttribute("aria-describedby")).split(" ");
  const said = await Promise.all(described.map((id) => page.locator(`#${id}`).textContent()));
  assert.ok(said.some((words) => /^\(/.test(words.trim())), "what is asked describes the field");
  await field("b").fill("");
});

await step("a wrong answer is told, and how it was read", async () => {
  await answer("b", "123456");
  assert.match(await part("b").locator(".echo").textContent(), /Read as/);
  assert.match(await feedback("b").textContent(), /This is not the answer/);
  assert.equal(await part("b").locator(".attempts").textContent(), "1 attempt");
});

await step("hints come one by one", async () => {
  await part("a").getByRole("button", { name: "Hint" }).click();
  assert.match(await part("a").locator(".hints").textContent(), /Hint 1/);
});

await step("reloading keeps answer, attempts and hints", async () => {
  await page.reload();
  await ready();
  assert.equal(await field("b").inputValue(), "123456");
  assert.equal(await part("b").locator(".attempts").textContent(), "1 attempt");
  assert.match(await part("a").locator(".hints").textContent(), /Hint 1/);
  assert.match(await feedback("b").textContent(), /This is not the answer/);
});

await step("axe finds nothing in a marked question", () => check("marked"));

await step("another instance has other data", async () => {
  const before = await page.locator(".statement").textContent();
  await page.getByRole("button", { name: "Another one like this" }).click();
  assert.notEqual(await page.locator(".statement").textContent(), before);
  assert.equal(await field("a").inputValue(), "");
  assert.match(await page.locator("#announce").textContent(), /New data/);
  const focused = await page.evaluate(() => document.activeElement.tagName);
  assert.equal(focused, "H2");
});

await step("every question: shown, solved with its own key, marked right", async () => {
  const questions = await page.evaluate(() => globalThis.page.practice.questions.map(({ item }) => item));
  let [parts, right, failed] = [0, 0, []];
  for (const [question, item] of questions.entries()) {
    const { code } = await ask({ do: "choose", question, from: 1000 + question });
    const shown = await ask({ do: "show", question, code });
    if (shown.error) failed.push(`${item}: ${shown.error}`);
    for (const { id } of shown.parts ?? []) {
      const solved = await ask({ do: "solve", question, code, part: id });
      if (solved.error) failed.push(`${item} ${id}: ${solved.error}`);
      parts += 1;
      const marked = solved.right?.length
        ? await ask({ do: "mark", question, code, part: id, response: solved.right.join(", ") })
        : { verdict: "" };
      if (marked.verdict === "right") right += 1;
    }
  }
  assert.deepEqual(failed, []);
  return `${questions.length} questions, ${parts} parts, ${right} choices marked right`;
});

await step("axe finds nothing in a question with each kind of answer", async () => {
  const items = await page.evaluate(() => {
    const { grader, practice } = globalThis.page;
    const found = new Map();
    practice.questions.forEach(({ item }, question) => {
      const { code } = grader.ask({ do: "choose", question, from: 1 });
      for (const { kind, options = [] } of grader.ask({ do: "show", question, code }).parts ?? []) {
        const isFormula = options.some(({ text }) => text.startsWith("<math"));
        found.set(isFormula ? "choice of formulas" : kind, item);
      }
    });
    return [...found];
  });
  for (const [kind, item] of items) {
    await open(item);
    await check(`${kind}: ${item}`);
  }
  return items.map(([kind]) => kind).join(", ");
});

await step("a slipped unit is named, the right answer is right", async () => {
  await open("ch2/e8-springs-parallel-series");
  const letter = await page.evaluate(
    () => globalThis.page.stage.parts.find(({ part }) => part.kind === "numeric" && part.unit).part.letter,
  );
  await part(letter).getByRole("button", { name: "Show solution" }).click();
  const value = (await part(letter).locator(".solution .value mn").first().textContent()).trim();
  await answer(letter, `${value} kg`);
  const slipped = await feedback(letter).textContent();
  assert.match(slipped, /unit|mass/i);
  await answer(letter, value);
  assert.match(await feedback(letter).textContent(), /^Right/);
  return slipped.trim().replace(/\s+/g, " ");
});

await step("a hostile answer stays text", async () => {
  const before = await page.locator("script").count();
  const letter = await page.evaluate(() => globalThis.page.stage.parts[0].part.letter);
  for (const text of ["<img src=x onerror=alert(1)>", "</script><script>alert(1)</script>", "(".repeat(3999), "\u0000\u001b[2J\u202e", "9".repeat(3999)]) {
    await answer(letter, text);
    assert.equal(await part(letter).locator("img, script").count(), 0);
  }
  assert.equal(await page.locator("script").count(), before);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, "no sideways scrolling");
});

await step("marking", async () => {
  const result = await page.evaluate(() => {
    const { grader, number, stage } = globalThis.page;
    const { code } = stage.record;
    const request = { do: "mark", question: number, code, part: stage.parts[0].id, response: "12.5 N/m" };
    for (let run = 0; run < 50; run += 1) grader.ask(request);
    const begun = performance.now();
    for (let run = 0; run < 500; run += 1) grader.ask(request);
    return (performance.now() - begun) / 500;
  });
  assert.ok(result < 5, `${result} ms`);
  return `${(1000 * result).toFixed(0)} µs an answer`;
});

await step("marking of every part of the bank", async () => {
  const slow = await page.evaluate(() => {
    const { grader, practice } = globalThis.page;
    const times = [];
    practice.questions.forEach(({ item }, question) => {
      const { code } = grader.ask({ do: "choose", question, from: 5 });
      const { parts = [] } = grader.ask({ do: "show", question, code });
      for (const { id } of parts) {
        const request = { do: "mark", question, code, part: id, response: "2.5" };
        grader.ask(request);
        const begun = performance.now();
        for (let run = 0; run < 5; run += 1) grader.ask(request);
        times.push([(performance.now() - begun) / 5, `${item} ${id}`]);
      }
    });
    times.sort(([a], [b]) => a - b);
    const at = (share) => times[Math.floor(share * (times.length - 1))][0].toFixed(2);
    return `median ${at(0.5)} ms, 95 % ${at(0.95)} ms, slowest ${at(1)} ms (${times.at(-1)[1]})`;
  });
  return slow;
});

await step("matrices have an input for each entry", async () => {
  const item = await page.evaluate(() => {
    const { grader, practice } = globalThis.page;
    return practice.questions.findIndex((_, question) => {
      const { code } = grader.ask({ do: "choose", question, from: 3 });
      return grader.ask({ do: "show", question, code }).parts?.some(({ rows, columns }) => rows > 1 && columns > 1);
    });
  });
  assert.ok(item >= 0);
  await open(await page.evaluate((at) => globalThis.page.practice.questions[at].item, item));
  const grid = page.locator(".entries").first();
  const cells = grid.locator("input");
  for (let at = 0; at < (await cells.count()); at += 1) await cells.nth(at).fill(String(at + 1));
  await page.waitForTimeout(300);
  await page.reload();
  await ready();
  assert.equal(await page.locator(".entries").first().locator("input").nth(1).inputValue(), "2");
  await page.screenshot({ path: "shots/matrix.png", fullPage: true });
});

/** Opens the motion of a question behind its first solution. */
const move = async (on) => {
  await on.getByRole("button", { name: "Show solution" }).first().click();
  const open = on.getByRole("button", { name: "Show the motion" });
  assert.equal(await open.count(), 1);
  await open.focus();
  await on.keyboard.press("Enter");
};
/** What is drawn of the moving part. */
const picture = (on) => on.locator(".motion .moving").innerHTML();

await step("the system moves when it is asked to, and not before", async () => {
  await open("ch5/p1-stepped-disk-two-blocks");
  await move(page);
  const still = await picture(page);
  await page.waitForTimeout(300);
  assert.equal(await picture(page), still, "it does not start by itself");
  const control = (name) => page.locator(".motion").getByRole("button", { name });
  await control("Play").focus();
  await page.keyboard.press("Space");
  await page.waitForTimeout(400);
  assert.notEqual(await picture(page), still, "it plays");
  await page.screenshot({ path: "shots/motion-plays.png", fullPage: true });
  await page.keyboard.press("Space");
  const paused = await picture(page);
  await page.waitForTimeout(200);
  assert.equal(await picture(page), paused, "it pauses");
  await control("Slow motion").click();
  assert.equal(await control("Slow motion").getAttribute("aria-pressed"), "true");
  const time = page.locator(".motion").getByRole("slider", { name: "Time" });
  await time.focus();
  await page.keyboard.press("Home");
  assert.equal(await picture(page), still, "the time goes back to the beginning");
  await page.locator(".motion select").selectOption({ label: "mode 2" });
  await page.locator(".motion summary").click();
  assert.ok((await page.locator(".motion tbody tr").count()) >= 4);
  await check("the motion");
  await page.screenshot({ path: "shots/motion-mode.png", fullPage: true });
  const size = await page.evaluate(() => globalThis.page.stage.motion.textContent.length);
  return `${size} letters around it`;
});

await step("it stays still where less motion is asked for", async () => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open("ch3/e4-underdamped-response");
  await move(page);
  assert.equal(await page.locator(".motion").getByRole("button", { name: "Play" }).count(), 0);
  const still = await picture(page);
  await page.locator(".motion input[type=range]").focus();
  await page.keyboard.press("PageUp");
  assert.notEqual(await picture(page), still, "the time can be moved");
  await check("the motion, still");
  await page.emulateMedia({ reducedMotion: null });
});

await step("by keyboard alone", async () => {
  await open(`${FIRST}/${CODE}`);
  await field("a").focus();
  await page.keyboard.type("1.5");
  await page.keyboard.press("Enter");
  assert.notEqual((await feedback("a").textContent()).trim(), "");
  const outline = await field("a").evaluate((input) => getComputedStyle(input).outlineStyle);
  assert.equal(outline, "solid");
});

await step("where nothing may be kept, the page works on", async () => {
  const other = await (await browser.newContext()).newPage();
  await other.addInitScript(() => {
    Object.defineProperty(globalThis, "localStorage", { get: () => { throw new DOMException("denied", "SecurityError"); } });
  });
  await other.goto(address);
  await other.waitForSelector("html[data-ready]");
  assert.ok(await other.locator("#kept").isVisible());
  await other.close();
});

const looks = [
  ["desktop", { width: 1280, height: 900 }, "light"],
  ["desktop-dark", { width: 1280, height: 900 }, "dark"],
  ["phone", { width: 390, height: 844 }, "light"],
  ["phone-dark", { width: 390, height: 844 }, "dark"],
];
for (const [name, viewport, colorScheme] of looks) {
  await step(`looks: ${name}`, async () => {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme });
    await open(`ch4/p1-rolling-disk-hub-moment/${CODE}`);
    await answer("a", "3/2 m x'' + b x' + k x = 0");
    const solve = part("b").getByRole("button", { name: "Show solution" });
    if (await solve.isEnabled()) await solve.click();
    await page.waitForTimeout(200);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, "no sideways scrolling");
    await check(name);
    await page.screenshot({ path: `shots/${name}.png`, fullPage: true });
  });
}

await step("prints without buttons", async () => {
  await page.emulateMedia({ media: "print", colorScheme: "light" });
  assert.equal(await page.locator("button:visible").count(), 0);
  await page.pdf({ path: "shots/print.pdf", format: "A4" });
});

await step("the page's own security policy lets its program run", async () => {
  const strict = await (await browser.newContext({ bypassCSP: false })).newPage();
  const errors = [];
  strict.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await strict.goto(address);
  await strict.waitForSelector("html[data-ready]", { timeout: 10_000 });
  await strict.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "globalThis.injected = true";
    document.body.append(script);
  });
  assert.equal(await strict.evaluate(() => globalThis.injected), undefined, "injected scripts do not run");
  assert.ok(errors.every((error) => /Content Security Policy/.test(error)), errors.join("\n"));
});

await browser.close();
assert.deepEqual(complaints, [], "the console is empty");
console.log("ok  the console is empty and nothing was fetched");
