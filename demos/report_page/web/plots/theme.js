// Light and dark: follows the system until the switch is used; plots are told by "themechange".

const system = matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;
let chosen = null;
let printing = false;
let colours = {};

function apply() {
  const theme = printing ? "light" : chosen ?? (system.matches ? "dark" : "light");
  root.dataset.theme = theme;
  colours = {};
  dispatchEvent(new CustomEvent("themechange"));
  return theme;
}

/** Value of the style sheet's variable, for instance "--ink". */
export function colour(variable) {
  colours[variable] ??= getComputedStyle(root).getPropertyValue(variable).trim();
  return colours[variable];
}

/** Colour of the i-th line, told apart by colour-blind readers too. */
export const lineColour = (i) => colour(`--line${(i % 8) + 1}`);

/** Makes `button` the switch. */
export function startTheme(button) {
  const say = (theme) => {
    button.textContent = theme === "dark" ? "Light" : "Dark";
    button.setAttribute("aria-label", `Switch to ${button.textContent.toLowerCase()} colours`);
  };
  button.addEventListener("click", () => {
    chosen = root.dataset.theme === "dark" ? "light" : "dark";
    say(apply());
  });
  system.addEventListener("change", () => say(apply()));
  addEventListener("beforeprint", () => {
    printing = true;
    apply();
  });
  addEventListener("afterprint", () => {
    printing = false;
    apply();
  });
  say(apply());
}
