(limits) => {
  const faults = [];
  const say = (element, what) => faults.push(`${what}: ${element.outerHTML.slice(0, 140)}`);
  const shown = (element) =>
    element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
    element.getClientRects().length > 0;
  const box = (element) => element.getBoundingClientRect();
  // The link over the menu is there for the keyboard alone until it has the focus; what only a
  // screen reader finds is one pixel large.
  const reachable = (element) =>
    shown(element) && box(element).bottom > 0 && box(element).right > 0 && box(element).width > 1;
  const all = (selector) => [...document.querySelectorAll(selector)].filter(reachable);

  if (!["en", "es", "ca"].includes(document.documentElement.lang)) {
    faults.push(`language “${document.documentElement.lang}”`);
  }
  if (document.querySelectorAll("h1").length !== 1) {
    faults.push(`${document.querySelectorAll("h1").length} h1`);
  }

  // Text.
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const measured = new Set();
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!node.textContent.trim() || measured.has(element) || !reachable(element)) continue;
    if (element.closest("script, style, template, noscript")) continue;
    measured.add(element);
    let size = parseFloat(getComputedStyle(element).fontSize);
    const drawing = element.closest("svg");
    if (drawing) {
      // In a drawing the text is as much larger or smaller as the drawing is.
      const matrix = element.getScreenCTM();
      size *= Math.hypot(matrix.a, matrix.b);
      if (drawing.getAttribute("aria-hidden") === "true") continue;
    }
    if (size < limits.text - 0.1) say(element, `text of ${size.toFixed(1)} px`);
  }

  // Cells and other controls.
  const cells = all('form.board button[name="cell"], form[data-board] button[name="cell"]');
  const controls = all(
    'a[href], button, input:not([type="hidden"]), select, textarea, summary, [tabindex="0"]',
  ).filter((element) => !cells.includes(element));
  for (const cell of cells) {
    if (!cell.getAttribute("aria-label")) say(cell, "a cell without a name");
    if (limits.patient && Math.min(box(cell).width, box(cell).height) < limits.cell - 0.5) {
      say(cell, `a cell of ${box(cell).width.toFixed(0)} x ${box(cell).height.toFixed(0)} px`);
    }
  }
  for (const control of controls) {
    if (control.matches("input") && control.closest("label")) continue; // the label is pressed
    const inline = control.matches("a") && getComputedStyle(control).display === "inline";
    if (inline && !limits.patient) continue; // WCAG 2.5.8 excepts links in a sentence
    const { width, height } = box(control);
    if (Math.min(width, height) < limits.button - 0.5) {
      say(control, `a control of ${width.toFixed(0)} x ${height.toFixed(0)} px`);
    }
  }
  if (limits.patient) {
    if (controls.length > limits.controls) {
      faults.push(`${controls.length} controls: ${controls.map((one) => one.outerHTML.slice(0, 60))}`);
    }
    controls.forEach((one, index) => {
      for (const other of controls.slice(index + 1)) {
        const [a, b] = [box(one), box(other)];
        const across = Math.max(b.left - a.right, a.left - b.right);
        const down = Math.max(b.top - a.bottom, a.top - b.bottom);
        const gap = Math.max(across, down);
        if (gap < limits.gap - 0.5) say(one, `${gap.toFixed(0)} px from another control`);
      }
    });
  }

  // Motion: short, and never for ever.
  const milliseconds = (text) =>
    Math.max(...text.split(",").map((one) => parseFloat(one) * (one.trim().endsWith("ms") ? 1 : 1000)));
  for (const element of all("body, body *")) {
    const style = getComputedStyle(element);
    const moves = style.animationName !== "none";
    if (moves && style.animationIterationCount.includes("infinite")) say(element, "motion for ever");
    const longest = Math.max(
      moves ? milliseconds(style.animationDuration) : 0,
      milliseconds(style.transitionDuration),
    );
    if (longest > limits.motion) say(element, `motion of ${longest} ms`);
  }

  // Help at the same place on each page: one link, in the head of the page.
  if (!limits.patient && all('header a[href="/help"]').length !== 1) faults.push("no help in the head");
  return faults;
}
