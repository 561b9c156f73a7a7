// Prints pages of sheets in Chromium and looks at the PDF: each sheet begins a page, pages are numbered anew with each sheet,
// and no question, figure or blank that fits on a page is torn. Boxes are those of the PDF: named places at the first and last
// line of each element, which Chromium writes for the targets of links.
//
// usage: node print.mjs SHEETS.html CHROMIUM [MOST-PAGES-PER-SHEET]

import { pathToFileURL } from "node:url";
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { getDocument } from "pdfjs-dist/legacy/build/pdf.mjs";

const [, , file, executablePath, most] = process.argv;
if (!file || !executablePath) {
  console.error("usage: node print.mjs SHEETS.html CHROMIUM [MOST-PAGES-PER-SHEET]");
  process.exit(2);
}
const faults = [];
const expect = (holds, words) => holds || faults.push(words);

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage();
await page.goto(pathToFileURL(resolve(file)).href);
// As wide as what is printed on, so that the height of an element is the one that it has on paper.
const isLetter = await page.evaluate(() => /@page \{ size: letter/.test(document.querySelector("style").textContent));
const [width, room] = isLetter ? [215.9 - 34, 279.4 - 25] : [210 - 34, 297 - 34];
const pixels = (millimetres) => Math.floor((millimetres / 25.4) * 96);
await page.emulateMedia({ media: "print" });
await page.setViewportSize({ width: pixels(width), height: pixels(room) });
// Ends of each sheet, question and figure become places that a link names. They take no room.
const marked = await page.evaluate(() => {
  const list = document.createElement("div");
  list.style.cssText = "position: absolute; top: 0; left: 0; width: 1px; height: 1px; overflow: hidden; font-size: 1px";
  const marked = [];
  const mark = (element, what, sheet) => {
    const key = `${what.split(" ")[0]}-${marked.length}`;
    element.style.position = "relative";
    for (const end of ["top", "bottom"]) {
      const place = document.createElement("span");
      place.id = `${key}-${end}`;
      place.style.cssText = `position: absolute; left: 0; ${end}: 0; width: 1px; height: 1px`;
      element.append(place);
      const link = document.createElement("a");
      link.href = `#${place.id}`;
      link.textContent = ".";
      list.append(link);
    }
    marked.push({ key, what, sheet, height: element.getBoundingClientRect().height });
  };
  document.querySelectorAll("article.sheet").forEach((article, sheet) => {
    mark(article, "sheet", sheet);
    // Keys and worked solutions go on from page to page between their parts.
    article.querySelectorAll(".question:not(.long)").forEach((question) => mark(question, "question", sheet));
    article.querySelectorAll(".setting, .blank, .options").forEach((element) => mark(element, element.className, sheet));
    article.querySelectorAll("figure").forEach((figure) => mark(figure, "figure", sheet));
  });
  document.querySelector("article.sheet").append(list);
  return marked;
});
const pdf = await getDocument({
  data: new Uint8Array(await page.pdf({ preferCSSPageSize: true, printBackground: false })),
}).promise;
await browser.close();

const destinations = await pdf.getDestinations();
const place = async (name) => {
  const found = destinations[name];
  if (!found) throw new Error(`the PDF has no place ${name}`);
  return { page: await pdf.getPageIndex(found[0]), y: found[3] };
};
const { view } = await pdf.getPage(1);
const height = view[3] - view[1];
const sheets = [];
let torn = 0;
for (const { key, what, sheet, height: length } of marked) {
  const top = await place(`${key}-top`);
  const bottom = await place(`${key}-bottom`);
  if (what === "sheet") {
    sheets.push({ first: top.page, last: bottom.page });
    continue;
  }
  if (top.page === bottom.page) continue;
  // What is longer than a page cannot stay whole.
  const isLong = length > pixels(room);
  torn += 1;
  expect(isLong, `${what} ${key} of sheet ${sheet + 1} is torn between pages ${top.page + 1} and ${bottom.page + 1}`);
}
for (const [number, { first, last }] of sheets.entries()) {
  const before = sheets[number - 1];
  expect(!before || first === before.last + 1, `sheet ${number + 1} does not begin a page of its own`);
  if (most) expect(last - first + 1 <= Number(most), `sheet ${number + 1} has ${last - first + 1} pages, not at most ${most}`);
  for (let at = first; at <= last; at += 1) {
    const { items } = await (await pdf.getPage(at + 1)).getTextContent();
    const foot = items.filter((item) => item.transform[5] < height * 0.07).map((item) => item.str).join("");
    expect(foot.includes(`page ${at - first + 1}`), `page ${at - first + 1} of sheet ${number + 1} says: ${foot}`);
  }
}
expect(sheets.length > 0, "there is no sheet");
expect(sheets.at(-1)?.last === pdf.numPages - 1, `${pdf.numPages} pages, the last sheet ends on ${sheets.at(-1)?.last + 1}`);
if (faults.length > 0) {
  console.error(faults.join("\n"));
  process.exit(1);
}
const elements = marked.length - sheets.length;
console.log(`${sheets.length} sheets on ${pdf.numPages} pages, ${elements} questions, figures and blanks, ${torn} longer than a page`);
