// Reads the scene, then starts the page: its modules may take the scene as given.
import {load} from "./data.js";

function tellProblem(problem) {
  const row = document.createElement("div");
  row.className = "message error";
  row.textContent = typeof DecompressionStream === "undefined"
    ? "this browser cannot read packed data: a version from 2023 or later can"
    : "the page cannot be shown: " + problem.message;
  document.getElementById("messages").append(row);
  document.getElementById("summary").textContent = "";
}

document.getElementById("summary").textContent = "reading the path ...";
load().then(() => import("./page.js")).catch(problem => {
  tellProblem(problem);
  throw problem;
});
