// Light or dark: as the system has it, until the button chooses; the choice is remembered.

const key = "dioptre-theme";
const system = matchMedia("(prefers-color-scheme: dark)");

/** Puts the theme on the page, and the button in charge of it. */
export function followTheme(button) {
  const chosen = () => localStorage.getItem(key) ?? (system.matches ? "dark" : "light");
  const apply = () => {
    document.documentElement.dataset.theme = chosen();
  };
  button.addEventListener("click", () => {
    localStorage.setItem(key, chosen() === "dark" ? "light" : "dark");
    apply();
  });
  system.addEventListener("change", apply);
  apply();
}
