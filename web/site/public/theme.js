// The theme before the first paint: that of the system unless the reader has chosen another here or
// on the page of scenes, which call "system" what VitePress calls "auto".
(() => {
  let choice = null;
  try {
    if (localStorage.getItem("thud-theme") === "system") localStorage.removeItem("thud-theme");
    choice = localStorage.getItem("thud-theme");
  } catch {
    // Storage is switched off.
  }
  const dark =
    choice === "dark" || (choice !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  const { classList } = document.documentElement;
  classList.toggle("dark", dark);
  // By this class the theme writes the key of the search as a Mac has it.
  classList.toggle("mac", /Mac|iPhone|iPod|iPad/i.test(navigator.platform));
})();
