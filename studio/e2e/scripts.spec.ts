/** Script components: the question whether they may run, and their editor. */
import type { Page } from "@playwright/test";

import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

function python(...code: string[]): string {
  const lines = code.map((line) => `        ${line}`).join("\n");
  return `katydid 1
s = Number Slider(21, 0..100)
twice = \`GhPython Script\` @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {
    CodeInput = """
${lines}
        """
    HideInput = true
}
shown = Panel(twice.a)
`;
}

const C_SHARP = `katydid 1
s = Number Slider(21, 0..100)
sharp = \`C# Script\` @a9a8ebd2-fff5-4c44-a8f5-739736d129ba(x = s) variable -> out, A {
    ScriptSource = "A = x;"
}
`;

const question = (page: Page) => page.getByRole("alert").filter({ hasText: "Python script" });
const editor = (page: Page) => page.getByRole("dialog", { name: /^Script: / });
const code = (page: Page) => editor(page).getByRole("textbox", { name: "Text of the script" });
const script = (page: Page, name = "twice") => page.getByRole("group", { name: new RegExp(`^${name}, `) });
const panel = (page: Page, text: string) => page.getByRole("group", { name: /^shown, / }).locator(".item").filter({ hasText: new RegExp(`^${text}$`) });

async function openEditor(page: Page, name?: string): Promise<void> {
  await script(page, name).dblclick({ position: { x: 40, y: 8 } });
  await expect(code(page)).toBeVisible();
}

/** Gives the script another text. */
async function write(page: Page, text: string): Promise<void> {
  await code(page).focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText(text);
}

test("a script runs once its owner has looked at it, and the answer holds for the file", async ({ page }) => {
  const file = python("import os", "a = x * 2  # asked once");
  await openText(page, "asked.kd", file);
  await expect(question(page)).toBeVisible();
  await expect(panel(page, "42")).toHaveCount(0);
  await question(page).getByRole("button", { name: "Look at the code" }).click();
  const dialog = page.getByRole("dialog", { name: "Scripts of this definition" });
  await expect(dialog).toContainText("a = x * 2");
  await expect(dialog.locator(".imports")).toContainText("os");
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await isAccessible(page);
  }
  await dialog.getByRole("button", { name: "Run", exact: true }).click();
  await expect(dialog).toHaveCount(0);
  await expect(question(page)).toHaveCount(0);
  await expect(panel(page, "42").first()).toBeVisible();
  // The same bytes again are not asked about; others are.
  await openText(page, "again.kd", file);
  await expect(panel(page, "42").first()).toBeVisible();
  await expect(question(page)).toHaveCount(0);
  await openText(page, "other.kd", `${file}\nmore = Panel("more")\n`);
  await expect(question(page)).toBeVisible();
});

test("a script that was told not to run does not", async ({ page }) => {
  await openText(page, "refused.kd", python("a = x * 2  # refused"));
  await question(page).getByRole("button", { name: "Do not run" }).click();
  await expect(question(page)).toHaveCount(0);
  await expect(panel(page, "42")).toHaveCount(0);
});

test("the editor shows the error at its line, tests, and is one step for Undo", async ({ page }) => {
  await openText(page, "edited.kd", python("a = x * 2  # edited"));
  await question(page).getByRole("button", { name: "Run", exact: true }).click();
  await expect(panel(page, "42").first()).toBeVisible();
  await openEditor(page);
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await isAccessible(page);
  }
  await write(page, "y = x\na = y / 0");
  await page.keyboard.press("ControlOrMeta+Enter");
  const messages = editor(page).getByRole("log", { name: "Messages" });
  await expect(messages).toContainText("division");
  await expect(editor(page).locator(".cm-lint-marker-error")).toBeVisible();
  await messages.getByRole("button", { name: "line 2" }).click();
  await expect(code(page).locator(".cm-activeLine")).toHaveText("a = y / 0");
  await write(page, "a = number + 1");
  // The input gets another name, a hint and an access; a second one comes.
  const inputs = editor(page).getByRole("region", { name: "Inputs" });
  await inputs.getByRole("textbox", { name: "Input", exact: true }).first().fill("number");
  await page.keyboard.press("Enter");
  await inputs.getByRole("combobox", { name: "Type hint" }).first().selectOption("int");
  await inputs.getByRole("combobox", { name: "Access" }).first().selectOption("list");
  await expect(inputs.getByRole("combobox", { name: "Access" }).first()).toHaveValue("list");
  await inputs.getByRole("combobox", { name: "Access" }).first().selectOption("item");
  await inputs.getByRole("button", { name: "Add an input" }).click();
  await expect(inputs.getByRole("textbox", { name: "Input", exact: true })).toHaveCount(2);
  await inputs.getByRole("button", { name: /^Remove/ }).nth(1).click();
  await expect(inputs.getByRole("textbox", { name: "Input", exact: true })).toHaveCount(1);
  await editor(page).getByRole("button", { name: "Done" }).click();
  await expect(editor(page)).toHaveCount(0);
  await expect(panel(page, "22").first()).toBeVisible();
  await page.keyboard.press("ControlOrMeta+z");
  await expect(panel(page, "42").first()).toBeVisible();
  await openEditor(page);
  await expect(code(page)).toContainText("a = x * 2");
  await expect(inputs.getByRole("textbox", { name: "Input", exact: true }).first()).toHaveValue("x");
});

test("Escape keeps what was written, Discard takes it back, and Tab can leave the text", async ({ page }) => {
  await openText(page, "kept.kd", python("a = x * 2  # kept"));
  await question(page).getByRole("button", { name: "Run", exact: true }).click();
  await openEditor(page);
  await write(page, "a = x * 3");
  await page.keyboard.press("Escape");
  await expect(editor(page)).toHaveCount(0);
  await expect(panel(page, "63").first()).toBeVisible();
  await openEditor(page);
  await write(page, "a = x * 4");
  await page.keyboard.press("ControlOrMeta+Enter");
  await expect(editor(page).getByRole("log")).toContainText("without a message");
  await code(page).focus();
  await page.keyboard.press("Control+m");
  await page.keyboard.press("Tab");
  await expect(code(page)).not.toBeFocused();
  await editor(page).getByRole("button", { name: "Discard changes" }).click();
  await expect(panel(page, "63").first()).toBeVisible();
});

test("a script in C# is edited in its parts, and nobody is asked", async ({ page }) => {
  await openText(page, "sharp.kd", C_SHARP);
  await expect(question(page)).toHaveCount(0);
  await script(page, "sharp").click({ position: { x: 40, y: 8 } });
  await page.keyboard.press("Enter");
  await expect(code(page)).toHaveText(/A = x;/);
  await write(page, "A = Twice(2);");
  await editor(page).getByRole("radio", { name: "Members" }).check();
  await write(page, "int Twice(int k) { return 2 * k; }");
  await editor(page).getByRole("radio", { name: "Script", exact: true }).check();
  await expect(code(page)).toHaveText("A = Twice(2);");
  await page.keyboard.press("Escape");
  await expect(editor(page)).toHaveCount(0);
  await openEditor(page, "sharp");
  await editor(page).getByRole("radio", { name: "Members" }).check();
  await expect(code(page)).toHaveText("int Twice(int k) { return 2 * k; }");
});
