// The report page of murk: draws the sections from the data that src/report/page.c puts into the page, then the view
// in space. Built into src/report/web/page.js by tools/report/build.
import { read } from "./data.js";
import { fit, prediction } from "./fit.js";
import { follow } from "./follow.js";
import { html } from "./html.js";
import { light } from "./light.js";
import { placement } from "./placement.js";
import { block } from "./results.js";
import { study } from "./study.js";
import { tallies } from "./tallies.js";
import { showView } from "./view.js";
import { where } from "./where.js";

const main = document.getElementById("main"), results = block("results"), space = read();

function put(before, draw) {
  const section = document.createElement("template");
  try {
    section.innerHTML = draw().text;
  } catch (problem) { // results of another form than murk writes
    section.innerHTML = html`<p class="note">A part of the page cannot be drawn: ${problem.message}.</p>`.text;
  }
  main.insertBefore(section.content, document.getElementById(before));
}

// Pictures stand between what is in space and the rest; the page has them without scripts.
const rest = document.getElementById("pictures") ? "pictures" : "made";
put(rest, () => placement(results));
put(rest, () => where(space, results.note));
for (const draw of [study, follow, fit, prediction, light, tallies]) put("made", () => draw(results));

const sections = [...main.querySelectorAll("section")].map(({ id, dataset }) => ({ id, title: dataset.title }));
const contents = document.createElement("nav");
contents.setAttribute("aria-label", "Contents");
contents.innerHTML = html`<ul>
${sections.map(({ id, title }) => html`<li><a href="#${id}">${title}</a></li>
`)}</ul>`.text;
document.querySelector("header").append(contents);

if (space) showView(space);
