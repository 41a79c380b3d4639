/** Support for the tests of games on the page: what they tell, and how they are played by touch. */

/** A value from the game's figures, up to date with the steps of `stepBy`. */
export function figureOf(page, label) {
  return page.evaluate((wanted) => {
    const terms = [...document.querySelectorAll("#figures dt")];
    return terms.find(({ textContent }) => textContent === wanted)?.nextSibling.textContent;
  }, label);
}

/** Simulates fingers on buttons of the pad. */
export async function fingers(page) {
  const touch = await page.context().newCDPSession(page);
  const middleOf = async (key) => {
    const box = await page.locator(`[data-key=${key}]`).boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  };
  return {
    async hold(...keys) {
      const touchPoints = [];
      for (const [id, key] of keys.entries()) {
        touchPoints.push({ ...(await middleOf(key)), id });
        await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
        await page.waitForSelector(`[data-key=${key}][data-held]`);
      }
    },
    async letGo() {
      await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
      await page.waitForSelector("[data-held]", { state: "detached" });
    },
  };
}
