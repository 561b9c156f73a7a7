// Shows what the program has made, and asks it for what it makes anew.

"use strict";

const by = (id) => document.getElementById(id);
const frames = [...document.querySelectorAll("iframe")];
let variant = 0;
let version;

/** An element with words in it; words are never read as markup. */
function element(name, words, kind) {
  const made = document.createElement(name);
  if (words !== undefined) made.textContent = words;
  if (kind) made.className = kind;
  return made;
}

/** A pane shows its sheet anew, at the place to which it was scrolled. */
function renew(frame) {
  const { scrollX = 0, scrollY = 0 } = frame.contentWindow ?? {};
  frame.onload = () => frame.contentWindow.scrollTo(scrollX, scrollY);
  frame.src = `${frame.name}?variant=${variant}&version=${version}`;
}

function tell({ title, count, code, student, duration, duration_minutes: given, minutes, points, questions }) {
  document.title = `${title} – preview`;
  by("title").textContent = title;
  const isLate = given !== null && minutes > given;
  const time = element("strong", duration ? `${minutes} minutes of work, ${duration} given` : `${minutes} minutes of work`, isLate ? "late" : "");
  by("sums").replaceChildren(`${points}, `, time, isLate ? ` – ${minutes - given} minutes too many` : "");
  by("variants").hidden = count < 2;
  by("variant").textContent = `${student ?? "variant"} ${variant + 1} of ${count}: ${code}`;
  by("before").disabled = variant === 0;
  by("after").disabled = variant + 1 >= count;
  const row = ({ number, title, item, points, minutes, parts }) => {
    const line = element("tr");
    const name = element("td", `${number}. ${title} `);
    name.append(element("code", item));
    const list = parts.map(({ letter, kind, points }) => `${letter}) ${kind}, ${points}`).join("; ");
    line.append(name, element("td", list), element("td", points), element("td", String(minutes)));
    return line;
  };
  by("rows").replaceChildren(...questions.map(row));
  const sum = element("tr");
  sum.append(element("th", "Sum"), element("td", ""), element("td", points), element("td", String(minutes)));
  by("foot").replaceChildren(sum);
}

function show({ version: now, file, trouble, sheet }) {
  const isNew = now !== version;
  version = now;
  document.documentElement.dataset.version = now;
  by("trouble").hidden = trouble === null;
  by("trouble").querySelector("pre").textContent = trouble === null ? "" : `${trouble.trimEnd()}${sheet ? `\n\nBelow is what ${file} gave before.` : ""}`;
  if (!sheet) return;
  variant = Math.min(variant, sheet.count - 1);
  tell(sheet);
  if (isNew && trouble === null) frames.forEach(renew);
}

async function ask(since) {
  const reply = await fetch(`state?variant=${variant}${since === undefined ? "" : `&since=${since}`}`);
  if (!reply.ok) throw new Error(reply.statusText);
  return reply.json();
}

async function turn(step) {
  variant += step;
  show(await ask());
  frames.forEach(renew);
}

/** Where the program has ended, the page says so and tries again: it may be started anew at the same address no more. */
async function follow() {
  for (;;) {
    try {
      show(await ask(version));
    } catch {
      by("trouble").hidden = false;
      by("trouble").querySelector("pre").textContent = "The program has ended; this page shows what it gave last.";
      await new Promise((ready) => setTimeout(ready, 2000));
    }
  }
}

by("before").addEventListener("click", () => turn(-1));
by("after").addEventListener("click", () => turn(1));
follow();
