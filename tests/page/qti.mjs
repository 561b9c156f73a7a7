// Drives a package of QTI 3 in a player of others: @citolab/qti-components, in Chromium.
//
//   cd tests/page && npm install && npm install --no-save @citolab/qti-components@7.27.4
//   node qti.mjs PACKAGE.zip [BROWSER]        BROWSER: /usr/bin/chromium if left out
//
// PACKAGE.zip is made by `vibank export qti --qti 3.0 --variants 1 --out PACKAGE.zip`. The player is under the GPL, which is
// why it is fetched for a run and is no dependency of anything here. Pictures go to `shots/`. Exit code 0: everything held.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { unzipSync } from "fflate";
import { chromium } from "playwright-core";

const [file, executablePath = "/usr/bin/chromium"] = process.argv.slice(2);
const files = unzipSync(readFileSync(file));
const player = readFileSync("node_modules/@citolab/qti-components/cdn/index.global.js");
mkdirSync("shots", { recursive: true });

const kinds = { xml: "text/xml", svg: "image/svg+xml" };
const server = createServer((request, response) => {
  const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname).slice(1);
  const send = (type, content, status = 200) => response.writeHead(status, { "Content-Type": type }).end(content);
  if (path === "") return send("text/html", `<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Player</title><script src="player.js"></script><main></main>`);
  if (path === "player.js") return send("text/javascript", player);
  if (files[path]) return send(kinds[path.split(".").pop()] ?? "text/plain", Buffer.from(files[path]));
  send("text/plain", "", 404);
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const page = await (await browser.newContext({ viewport: { width: 1000, height: 900 } })).newPage();
const missed = [];
page.on("response", (response) => response.status() >= 400 && !/favicon/.test(response.url()) && missed.push(response.url()));
await page.goto(`http://127.0.0.1:${server.address().port}/`);

/** Opens an item in the player. */
const open = (path) =>
  page.evaluate(async (path) => {
    const main = document.querySelector("main");
    main.replaceChildren();
    const holder = document.createElement("qti-item");
    const container = document.createElement("item-container");
    container.setAttribute("item-url", path);
    const connected = new Promise((ready) => holder.addEventListener("qti-assessment-item-connected", ({ detail }) => ready(detail), { once: true }));
    holder.append(container);
    main.append(holder);
    const item = await connected;
    await item.updateComplete;
    globalThis.item = item;
  }, path);

/** Types or chooses as somebody does, and has it marked; the score. */
async function answer(responses) {
  for (const [identifier, value] of Object.entries(responses)) {
    const entry = page.locator(`qti-text-entry-interaction[response-identifier="${identifier}"] input`);
    if ((await entry.count()) > 0) {
      await entry.fill(value);
      await entry.dispatchEvent("change");
    } else {
      const option = page.locator(`qti-choice-interaction[response-identifier="${identifier}"] qti-simple-choice[identifier="${value}"]`);
      // Chosen once more, an option is taken back.
      const isChosen = () => page.evaluate(([identifier, value]) => [globalThis.item.getResponse(identifier)?.value].flat().includes(value), [identifier, value]);
      if (!(await isChosen())) await option.click();
    }
  }
  return page.evaluate(() => {
    globalThis.item.resetResponses === undefined || (globalThis.item.getOutcome("SCORE").value = "0");
    globalThis.item.processResponse();
    const outcome = (name) => globalThis.item.getOutcome(name)?.value;
    return { score: Number(outcome("SCORE")), feedback: [outcome("FEEDBACK") ?? []].flat() };
  });
}

/** What a player is told about the boxes of an item: the key, and the ranges with what each is worth. */
const told = (xml) =>
  page.evaluate((xml) => {
    const document = new DOMParser().parseFromString(xml, "text/xml");
    const most = Number(document.querySelector('qti-outcome-declaration[identifier="MAXSCORE"] qti-value').textContent);
    const boxes = [...document.querySelectorAll("qti-response-declaration")].map((declared) => {
      const identifier = declared.getAttribute("identifier");
      const conditions = [...document.querySelectorAll("qti-response-if, qti-response-else-if")];
      const ranges = conditions.flatMap((condition) => {
        const bound = (name) => [...condition.querySelectorAll(`:scope > qti-and > ${name}, :scope > qti-or > qti-and > ${name}`)]
          .filter((own) => own.querySelector("qti-variable").getAttribute("identifier") === identifier)
          .map((own) => Number(own.querySelector("qti-base-value").textContent));
        const worth = condition.querySelector("qti-set-outcome-value qti-sum > qti-base-value");
        return bound("qti-gte").map((low, at) => ({ low, high: bound("qti-lte")[at], worth: Number(worth.textContent) }));
      });
      return { identifier, type: declared.getAttribute("base-type"), key: declared.querySelector("qti-value")?.textContent, ranges };
    });
    return { most, boxes };
  }, xml);

/** What numbers are worth by the ranges, the first that holds. */
const worth = ({ ranges }, value) => ranges.find(({ low, high }) => low <= value && value <= high)?.worth ?? 0;

const paths = Object.keys(files).filter((path) => path.endsWith("/item.xml") && !path.includes(".essay/"));
const sums = { items: 0, boxes: 0, choices: 0, pictures: 0, bounds: 0 };
for (const path of paths) {
  const { most, boxes } = await told(Buffer.from(files[path]).toString("utf8"));
  await open(path);
  const pictures = await page.evaluate(async () => {
    const images = [...globalThis.item.querySelectorAll("img")].concat([...(globalThis.item.shadowRoot?.querySelectorAll("img") ?? [])]);
    await Promise.all(images.map((image) => image.decode().catch(() => {})));
    return images.map(({ src, alt, naturalWidth }) => ({ src, alt, naturalWidth }));
  });
  for (const { src, alt, naturalWidth } of pictures) assert.ok(naturalWidth > 0 && alt.length > 10, `${path}: ${src}`);
  if (boxes.length === 0) continue;
  const right = Object.fromEntries(boxes.map(({ identifier, key }) => [identifier, key]));
  const { score } = await answer(right);
  assert.ok(Math.abs(score - most) < 1e-9, `${path}: ${score} of ${most} for the keys`);
  if (sums.items === 0) await page.screenshot({ path: "shots/qti.png", fullPage: true });
  // Numbers at and beyond each bound of the key, and far away: the player gives what the ranges say.
  const numbers = boxes.filter(({ type }) => type === "float" || type === "integer");
  for (const pick of [({ low }) => low * (1 - Math.sign(low) * 1e-9), ({ low }) => low * (1 + Math.sign(low) * 1e-9), ({ high }) => high * (1 - Math.sign(high) * 1e-9), ({ high }) => high * (1 + Math.sign(high) * 1e-9), () => 9999999]) {
    if (numbers.length === 0) break;
    const typed = Object.fromEntries(numbers.filter(({ ranges }) => ranges.length).map((box) => [box.identifier, String(pick(box.ranges[0]))]));
    const expected = boxes.reduce((sum, box) => sum + (box.identifier in typed ? worth(box, Number(typed[box.identifier])) : 0), 0);
    const others = boxes.filter(({ identifier }) => !(identifier in typed)).length;
    const got = (await answer(typed)).score;
    const kept = most - numbers.reduce((sum, box) => sum + worth(box, Number(box.key)), 0);
    assert.ok(Math.abs(got - expected - (others ? kept : 0)) < 1e-9, `${path}: ${got}, expected ${expected} for ${JSON.stringify(typed)}`);
    sums.bounds += Object.keys(typed).length;
  }
  // Each other option is wrong.
  for (const { identifier, key } of boxes.filter(({ type }) => type === "identifier")) {
    const options = await page.locator(`qti-choice-interaction[response-identifier="${identifier}"] qti-simple-choice`).evaluateAll((all) => all.map((own) => own.getAttribute("identifier")));
    const base = (await answer({ ...right, [identifier]: key })).score;
    assert.ok(Math.abs(base - most) < 1e-9);
    for (const option of options.filter((option) => option !== key)) {
      const { score } = await answer({ [identifier]: option });
      assert.ok(score < most - 1e-9, `${path}: ${option} is not right`);
    }
    sums.choices += options.length;
  }
  sums.items += 1;
  sums.boxes += boxes.length;
  sums.pictures += pictures.length;
}
assert.deepEqual(missed, [], "every picture is there");
assert.ok(sums.items > 0 && sums.boxes > 0);
console.log(`ok  ${Object.entries(sums).map(([name, count]) => `${count} ${name}`).join(", ")}`);
await browser.close();
server.close();
