// Measures what a page shows in Chromium: no letter of a figure leaves it or covers another, no heading is clipped, and
// nothing is wider than the page, on a screen, a telephone and paper; in the PDF, that no text leaves its page.
//
// usage: node figures.mjs CHROMIUM SHEETS.html…

import { pathToFileURL } from "node:url";
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { getDocument } from "pdfjs-dist/legacy/build/pdf.mjs";

const [, , executablePath, ...files] = process.argv;
if (files.length === 0) {
  console.error("usage: node figures.mjs CHROMIUM SHEETS.html…");
  process.exit(2);
}
const faults = [];
const WIDTHS = { screen: 1280, telephone: 390, paper: Math.floor(((210 - 34) / 25.4) * 96) };
let figures = 0;
let headings = 0;
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
for (const file of files) {
  const page = await browser.newPage();
  await page.goto(pathToFileURL(resolve(file)).href);
  for (const [kind, width] of Object.entries(WIDTHS)) {
    await page.emulateMedia({ media: kind === "paper" ? "print" : "screen" });
    await page.setViewportSize({ width, height: 900 });
    const seen = await page.evaluate(() => {
      // Rounding of boxes, and what two letters side by side may touch, in pixels.
      const ROOM = 1;
      const COVERED = 3;
      const found = [];
      const place = (element) => {
        const question = element.closest(".question");
        const sheet = [...document.querySelectorAll("article.sheet")].indexOf(element.closest("article.sheet"));
        return `sheet ${sheet + 1}, ${question?.querySelector("h2, h3, .title")?.textContent.trim() ?? element.tagName}`;
      };
      // The box of the letters themselves: a line leaves room above and below them.
      const canvas = document.createElement("canvas").getContext("2d");
      const inked = (text) => {
        const { left, right, top, bottom, height } = text.getBoundingClientRect();
        const { fontStyle, fontSize, fontFamily } = getComputedStyle(text.querySelector("tspan") ?? text);
        canvas.font = `${fontStyle} ${fontSize} ${fontFamily}`;
        // An index is small and low, however tall its digit: what rises is the letter before it.
        const letter = text.querySelector("tspan + tspan") ? text.querySelector("tspan") : text;
        const line = canvas.measureText(letter.textContent);
        const share = height / (line.fontBoundingBoxAscent + line.fontBoundingBoxDescent);
        const above = share * (line.fontBoundingBoxAscent - line.actualBoundingBoxAscent);
        // Indices hang below the line.
        const below = text.querySelector("tspan + tspan") ? 0 : share * (line.fontBoundingBoxDescent - line.actualBoundingBoxDescent);
        return { left, right, top: top + above, bottom: bottom - below };
      };
      // Drawings of figures alone: small signs and stretched letters are drawings, too.
      const drawings = [...document.querySelectorAll("figure svg")];
      for (const drawing of drawings) {
        const frame = drawing.getBoundingClientRect();
        const texts = [...drawing.querySelectorAll("text")].filter((text) => text.textContent.trim());
        const boxes = texts.map(inked);
        boxes.forEach((box, at) => {
          const leaves =
            box.left < frame.left - ROOM ||
            box.right > frame.right + ROOM ||
            box.top < frame.top - ROOM ||
            box.bottom > frame.bottom + ROOM;
          if (leaves) found.push(`${place(drawing)}: \`${texts[at].textContent}\` leaves its figure`);
          for (let other = at + 1; other < boxes.length; other += 1) {
            const across = Math.min(box.right, boxes[other].right) - Math.max(box.left, boxes[other].left);
            const down = Math.min(box.bottom, boxes[other].bottom) - Math.max(box.top, boxes[other].top);
            if (across > COVERED && down > COVERED)
              found.push(`${place(drawing)}: \`${texts[at].textContent}\` covers \`${texts[other].textContent}\``);
          }
        });
      }
      const heads = [...document.querySelectorAll("h1, h2, h3, h4, figcaption, th")].filter((head) => head.offsetParent);
      for (const head of heads) {
        const box = head.getBoundingClientRect();
        const scrolls = head.closest(".wide, .scroll, table");
        const isClipped = head.scrollWidth > head.clientWidth + ROOM || head.scrollHeight > head.clientHeight + 6;
        const leaves = !scrolls && (box.left < -ROOM || box.right > innerWidth + ROOM);
        if ((isClipped && getComputedStyle(head).overflow !== "visible") || leaves)
          found.push(`${place(head)}: the heading \`${head.textContent.trim().slice(0, 60)}\` is clipped`);
      }
      const root = document.documentElement;
      if (root.scrollWidth > innerWidth + ROOM) {
        const wide = [...document.querySelectorAll("body *")].find((element) => {
          const box = element.getBoundingClientRect();
          let parent = element.parentElement;
          while (parent && getComputedStyle(parent).overflowX === "visible") parent = parent.parentElement;
          return !parent && box.width > 0 && box.right > innerWidth + ROOM;
        });
        found.push(`the page is ${root.scrollWidth} wide, not ${innerWidth}: ${wide ? `${place(wide)}, ${wide.outerHTML.slice(0, 80)}` : ""}`);
      }
      return { found, figures: drawings.length, headings: heads.length };
    });
    figures += seen.figures;
    headings += seen.headings;
    faults.push(...seen.found.map((fault) => `${file}, ${kind}: ${fault}`));
  }
  const pdf = await getDocument({
    data: new Uint8Array(await page.pdf({ preferCSSPageSize: true, printBackground: false })),
  }).promise;
  for (let number = 1; number <= pdf.numPages; number += 1) {
    const leaf = await pdf.getPage(number);
    const [left, bottom, right, top] = leaf.view;
    const { items } = await leaf.getTextContent();
    for (const { str, width, transform } of items) {
      const [, , , , x, y] = transform;
      const isTurned = Math.abs(transform[1]) > 0.1;
      const isInside = x >= left && y >= bottom && y <= top && (isTurned || x + width <= right + 1);
      if (str.trim() && !isInside) faults.push(`${file}, page ${number}: \`${str}\` leaves the paper`);
    }
  }
  await page.close();
}
await browser.close();
if (faults.length > 0) {
  const many = faults.length > 60 ? `\n… ${faults.length} in all` : "";
  console.error(faults.slice(0, 60).join("\n") + many);
  process.exit(1);
}
console.log(`${figures} figures and ${headings} headings hold what they show, on screen, telephone and paper`);
