import { openText } from "./open";
import { expect, test } from "./test";

const GALLERY = `katydid 1
square = Mesh Plane(rectangle(plane((0, 0, 0)), 0..4, 0..4), 12, 12) hidden
picture = Mesh Colours(square, [rgb(200, 60, 50)]) hidden
paints = Colour Swatch() {
    SwatchColor = rgb(20, 160, 50)
}
secret = Panel("/etc/secret.png")
gallery = Image Gallery([picture, paints, secret])

layout {
    gallery: 300 0 [300 0 260 120]
}
`;

test("a gallery shows small pictures and colours, and names what may not be read", async ({ page }, info) => {
  await openText(page, "gallery.kd", GALLERY);
  const gallery = page.getByRole("group", { name: /^gallery: .*secret\.png$/ });
  const picture = gallery.locator("img");
  await expect(picture).toHaveCount(1);
  expect(await picture.evaluate((image: HTMLImageElement) => [image.complete, image.naturalWidth, image.naturalHeight])).toEqual([true, 160, 160]);
  await expect(gallery.locator("span[role=img]")).toHaveCSS("background-color", "rgb(20, 160, 50)");
  await expect(gallery.locator("span:not([role])")).toHaveText("secret.png");
  await page.screenshot({ path: info.outputPath("gallery.png") });
});
