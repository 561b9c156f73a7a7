// A course platform for the tests of SCORM packages: scorm-again in a page, its store in this process.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { strFromU8, unzipSync } from "fflate";
import { chromium } from "playwright-core";

/** What a package says of itself, `vibank.json`. */
export const described = (file) => JSON.parse(strFromU8(unzipSync(readFileSync(file))["vibank.json"]));

/** A platform with a package in it, which may be replaced by another as teachers do. */
export class Platform {
  /** What the platform keeps of each learner, and how it answers now. */
  kept = {};
  mode = "normal";
  isDown = false;
  commits = 0;
  complaints = [];

  static async start(file, executablePath) {
    const platform = new Platform();
    platform.upload(file);
    platform.server = createServer((request, response) => platform.serve(request, response));
    await new Promise((ready) => platform.server.listen(0, "127.0.0.1", ready));
    platform.address = `http://127.0.0.1:${platform.server.address().port}`;
    platform.browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
    return platform;
  }

  async stop() {
    await this.browser.close();
    this.server.close();
  }

  /** Puts a package in place of the one before; what is kept of learners stays. */
  upload(file) {
    this.files = unzipSync(readFileSync(file));
    this.about = JSON.parse(strFromU8(this.files["vibank.json"]));
    this.manifest = strFromU8(this.files["imsmanifest.xml"]);
    this.isOld = this.about.version === "1.2";
    this.library = readFileSync(new URL(`node_modules/scorm-again/dist/scorm${this.isOld ? "12" : "2004"}.min.js`, import.meta.url));
  }

  serve(request, response) {
    const { pathname } = new URL(request.url, "http://localhost");
    const [, folder, name] = pathname.split("/");
    const send = (type, content, status = 200) => response.writeHead(status, { "Content-Type": type }).end(content);
    if (folder === "library.js") return send("text/javascript", this.library);
    if (folder === "course") return send("text/html", this.host(name));
    if (folder === "package" && this.files[name]) return send("text/html", Buffer.from(this.files[name]));
    if (folder !== "commit") return send("text/plain", "", 404);
    let body = "";
    request.on("data", (chunk) => (body += chunk));
    request.on("end", () => {
      if (this.isDown) return request.socket.destroy();
      this.commits += 1;
      this.kept[name] = JSON.parse(body);
      send("application/json", JSON.stringify({ result: true, errorCode: 0 }));
    });
  }

  /** The page of the platform: the interface of the standard, every call of it noted, and the package in a frame. */
  host(learner) {
    return `<!DOCTYPE html><meta charset="utf-8"><title>Course</title>
<script src="/library.js"></script>
<body style="margin:0"><script>
  globalThis.calls = [];
  const isOld = ${this.isOld};
  const api = new (isOld ? Scorm12API : Scorm2004API)({ autocommit: false, lmsCommitUrl: "/commit/${learner}", logLevel: 5 });
  const kept = ${JSON.stringify(this.kept[learner] ?? null)};
  const entry = kept ? "resume" : "ab-initio";
  const [id, mode] = ${JSON.stringify([learner === "nobody" ? "" : learner, this.mode])};
  const cmi = structuredClone(kept?.cmi ?? {});
  if (isOld) Object.assign((cmi.core ??= {}), { student_id: id, student_name: "Learner", lesson_mode: mode, entry });
  else Object.assign(cmi, { learner_id: id, learner_name: "Learner", mode, entry });
  for (const own of [cmi, cmi.core ?? {}]) ["session_time", "exit"].forEach((name) => delete own[name]);
  api.loadFromJSON(cmi, "cmi");
  const error = isOld ? "LMSGetLastError" : "GetLastError";
  const noted = new Proxy(api, {
    get(target, name) {
      const value = target[name];
      if (!/^(LMS)?(Initialize|GetValue|SetValue|Commit|Finish|Terminate)$/.test(name)) return typeof value === "function" ? value.bind(target) : value;
      return (...values) => {
        const result = value.apply(target, values);
        calls.push({ name, values, result, error: String(target[error]()) });
        return result;
      };
    },
  });
  globalThis[isOld ? "API" : "API_1484_11"] = noted;
</script><iframe id="package" title="Package" src="/package/index.html" style="border:0;width:100vw;height:100vh;display:block"></iframe>`;
  }

  /** A sitting: a page of the platform in a profile of its own, or in a given one. */
  async sit(learner, context, viewport = { width: 1280, height: 900 }) {
    context ??= await this.browser.newContext({ viewport });
    const page = await context.newPage();
    page.on("dialog", (dialog) => dialog.accept());
    page.on("pageerror", (error) => this.complaints.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error" && !/commit\/|Failed to load resource|Network error|favicon/.test(message.text())) this.complaints.push(message.text());
    });
    await page.goto(`${this.address}/course/${learner}`);
    const frame = await (await page.waitForSelector("#package")).contentFrame();
    await frame.waitForSelector("html[data-ready]", { timeout: 60_000 });
    return { context, page, frame };
  }

  cmi(learner) {
    return this.kept[learner].cmi;
  }

  score(learner) {
    return Number(this.isOld ? this.cmi(learner).core.score.raw : this.cmi(learner).score.raw);
  }

  status(learner) {
    const cmi = this.cmi(learner);
    return this.isOld ? [cmi.core.lesson_status] : [cmi.completion_status, cmi.success_status];
  }

  interactions(learner) {
    const all = this.cmi(learner).interactions;
    return Object.values(all?.childArray ?? all ?? {}).filter((entry) => entry?.id);
  }
}

export const calls = ({ page }) => page.evaluate(() => globalThis.calls);
export const refused = async (sitting) => (await calls(sitting)).filter(({ error }) => error !== "0");

/** Leaves the page as a learner does: the platform goes elsewhere, and finishing is called for twice. */
export async function leave(sitting) {
  const { page, frame } = sitting;
  await frame.evaluate(() => {
    dispatchEvent(new PageTransitionEvent("pagehide"));
    dispatchEvent(new PageTransitionEvent("pagehide"));
  });
  const made = await calls(sitting);
  const ends = made.filter(({ name }) => /Finish|Terminate/.test(name));
  await page.goto("about:blank");
  return { made, ends };
}

export const part = (frame, letter) => frame.locator(`section[aria-labelledby="part-${letter}"]`);
export const ask = (frame, request) => frame.evaluate((request) => globalThis.page.grader.ask(request), request);
export const open = (frame, number) => frame.evaluate((number) => globalThis.page.open({ number }, false), number);

/** Answers as somebody does: by radio button, in a line, or in the entries of a matrix, which take a line too. */
export async function answer(frame, letter, text) {
  await type(frame, letter, text);
  await part(frame, letter).locator("button[type=submit]").click();
}

/** Answers, and does not say so. */
export async function type(frame, letter, text) {
  const section = part(frame, letter);
  const options = section.locator("input[type=radio], input[type=checkbox]");
  if ((await options.count()) > 0) {
    for (const letter of text.split(", ")) await section.locator(`input[value="${letter}"]`).check();
  } else {
    const line = section.locator(".line input[type=text]");
    if (!(await line.isVisible())) await section.locator("fieldset > p > button").click();
    await line.fill(text);
  }
}

/** What stands out of the page to the right, with its places. */
export const wide = (frame) =>
  frame.evaluate(() => {
    const over = document.documentElement.scrollWidth - innerWidth;
    const out = [...document.querySelectorAll("body *")].filter((element) => element.getBoundingClientRect().right > innerWidth + 0.5);
    return over <= 0 ? [] : [`${over} px`, ...out.map(({ tagName, className, id }) => `${tagName} ${className?.baseVal ?? className} ${id}`)];
  });

export async function step(name, action) {
  const said = await action();
  console.log(`ok  ${name}${said === undefined ? "" : `: ${said}`}`);
}
