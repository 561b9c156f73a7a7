// Answers a sheet on its page in a real browser, opened from disk, with the keyboard alone.
//
//   cd tests/page && npm install
//   node form.mjs PAGE.html ANSWERS.json [BROWSER]        BROWSER: /usr/bin/chromium if left out
//
// PAGE.html is made by `vibank form` of a run of `tests/page/form.toml`; what the page saves goes to ANSWERS.json, for
// `vibank grade`. Pictures go to `shots/`. Exit code 0: everything held. Every step prints one line.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { HtmlValidate } from "html-validate";
import { chromium } from "playwright-core";

const [file, saved, executablePath = "/usr/bin/chromium"] = process.argv.slice(2);
const address = pathToFileURL(file).href;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
mkdirSync("shots", { recursive: true });

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, bypassCSP: true, acceptDownloads: true });
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
const check = async (name) => {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`);
  assert.deepEqual(found, [], name);
};
const focused = () => page.evaluate(() => ({ id: document.activeElement.id, tag: document.activeElement.tagName, type: document.activeElement.type }));
/** Goes on with the tab key until a test holds. */
const tabTo = async (holds) => {
  for (let count = 0; count < 400; count += 1) {
    await page.keyboard.press("Tab");
    if (holds(await focused())) return;
  }
  assert.fail("the tab key does not get there");
};

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
  return `${await page.locator("section.part").count()} parts`;
});

await step("it cannot be asked for a key", async () => {
  const replies = await page.evaluate(() => {
    const { grader, code, parts } = globalThis.page;
    const own = parts.find((part) => part.part.reads);
    const about = { question: own.at, code, part: own.part.reads };
    return [grader.ask({ do: "solve", ...about }), grader.ask({ do: "show", question: own.at, code })];
  });
  // What it carries in place of a key is one of a unit, whatever the question.
  assert.match(replies[0].key, /alttext="[^"]*\b1 s\b/);
  assert.equal(replies[0].html, "");
  assert.equal(replies[1].statement.replace(/<[^>]*>/g, "").trim(), "");
});

await step("axe, before", () => check("before"));

await step("the tab key comes to all fields in their order", async () => {
  const ids = await page.locator("main input[type=text], main input[type=radio], main input[type=checkbox]").evaluateAll((all) =>
    all.filter((own) => own.checkVisibility()).map((own) => own.id),
  );
  await page.evaluate(() => document.activeElement.blur());
  const met = [];
  for (let count = 0; count < 600 && met.at(-1) !== "save"; count += 1) {
    await page.keyboard.press("Tab");
    const { id } = await focused();
    if (id) met.push(id);
  }
  assert.equal(met.at(-1), "save");
  const order = met.filter((id) => ids.includes(id));
  assert.deepEqual(order, ids.filter((id) => order.includes(id)));
  return `${order.length} stops`;
});

await step("answers are read, and what cannot be read is told", async () => {
  await page.evaluate(() => globalThis.scrollTo(0, 0));
  await page.locator("#question").focus();
  await tabTo(({ type }) => type === "text");
  await page.keyboard.type("about three");
  const first = page.locator("section.part").first();
  await first.locator(".echo.unread").waitFor();
  assert.match(await first.locator(".echo").textContent(), /Cannot be read/);
  await page.locator("#unread li").first().waitFor();
  await page.screenshot({ path: "shots/form-unread.png", fullPage: true });
  await check("unreadable");
  await first.locator("input[type=text]").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("2 pi/omega_n");
  await first.locator(".echo math").waitFor();
  assert.match(await first.locator(".echo").textContent(), /Read as/);
  await page.waitForFunction(() => document.querySelectorAll("#unread li").length === 0);
});

await step("a choice is made with the space bar", async () => {
  await tabTo(({ type }) => type === "radio");
  await page.keyboard.press("Space");
  assert.equal(await page.locator("input[type=radio]:checked").count(), 1);
});

await step("answers are there again after the page was closed", async () => {
  await page.reload();
  await ready();
  assert.equal(await page.locator("section.part input[type=text]").first().inputValue(), "2 pi/omega_n");
  assert.equal(await page.locator("input[type=radio]:checked").count(), 1);
});

await step("they are saved with the enter key", async () => {
  await tabTo(({ id }) => id === "save");
  const download = page.waitForEvent("download");
  await page.keyboard.press("Enter");
  const own = await download;
  await own.saveAs(saved);
  const answers = JSON.parse(readFileSync(saved, "utf8"));
  assert.equal(answers.format, "vibank answers 1");
  assert.equal(answers.answers[0].response, "2 pi/omega_n");
  assert.match(await page.locator("#saved").textContent(), /Saved as/);
  return own.suggestedFilename();
});

await step("a saved file is loaded again", async () => {
  page.once("dialog", (dialog) => dialog.accept());
  await page.locator("#forget").focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator("section.part input[type=text]").first().inputValue(), "");
  await page.locator("#load").setInputFiles(saved);
  await page.waitForFunction(() => document.querySelector("section.part input[type=text]").value === "2 pi/omega_n");
  const other = saved.replace(/\.json$/, "-other.json");
  writeFileSync(other, readFileSync(saved, "utf8").replace(/"code": "[^"]*"/, '"code": "AAA-AAA-AAA"'));
  await page.locator("#load").setInputFiles(other);
  await page.waitForFunction(() => /no answers to sheet/.test(document.getElementById("saved").textContent));
});

await step("axe, after; in dark colours and on a telephone", async () => {
  await check("after");
  await page.emulateMedia({ colorScheme: "dark" });
  // Colours of buttons take a moment to turn.
  await page.waitForTimeout(400);
  await check("dark");
  await page.screenshot({ path: "shots/form-dark.png", fullPage: true });
  await page.emulateMedia({ colorScheme: "light" });
  await page.waitForTimeout(400);
  await page.setViewportSize({ width: 390, height: 800 });
  await check("telephone");
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} pixels wide`);
  await page.screenshot({ path: "shots/form-telephone.png", fullPage: true });
});

assert.deepEqual(complaints, []);
await browser.close();
