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
  const FOCUSABLE =
    'a[href], button, input:not([type="hidden"]), select, textarea, summary, [tabindex="0"]';
  const controls = all(FOCUSABLE).filter((element) => !cells.includes(element));
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

  // Focus: a ring around whatever has it, that stands out from what it lies on and is not cut off.
  const colour = (text) => {
    const [red, green, blue, alpha = 1] = text.match(/[\d.]+/g).map(Number);
    return { rgb: [red, green, blue], alpha };
  };
  const over = (above, below) =>
    above.rgb.map((one, index) => one * above.alpha + below[index] * (1 - above.alpha));
  const luminance = (rgb) => {
    const [red, green, blue] = rgb
      .map((one) => one / 255)
      .map((one) => (one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const contrast = (one, other) => {
    const [dark, light] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (light + 0.05) / (dark + 0.05);
  };
  const around = (element) => {
    const found = [];
    for (let one = element.parentElement; one; one = one.parentElement) found.push(one);
    return found;
  };
  const holds = (element, [x, y]) => {
    const { left, right, top, bottom } = box(element);
    return left <= x && x <= right && top <= y && y <= bottom;
  };
  const ground = (element, point) =>
    [element, ...around(element)]
      .filter((one) => one === document.documentElement || holds(one, point))
      .reduceRight((below, one) => over(colour(getComputedStyle(one).backgroundColor), below), [
        255, 255, 255,
      ]);
  // Of a box that scrolls, what can be scrolled to; an outline makes it no larger.
  const room = (one) => {
    const root = one === document.documentElement;
    const left = root ? -scrollX : box(one).left + one.clientLeft - one.scrollLeft;
    const top = root ? -scrollY : box(one).top + one.clientTop - one.scrollTop;
    return { left, top, right: left + one.scrollWidth, bottom: top + one.scrollHeight };
  };
  const cuts = (one) =>
    one === document.documentElement ||
    (one !== document.body && getComputedStyle(one).overflowX !== "visible");
  const look = (element) => {
    element.focus({ preventScroll: true, focusVisible: true });
    const style = getComputedStyle(element);
    const width = parseFloat(style.outlineWidth);
    if (document.activeElement !== element) return say(element, "takes no focus");
    if (style.outlineStyle === "none" || width < limits.ring) {
      return say(element, `a focus ring of ${style.outlineStyle === "none" ? 0 : width} px`);
    }
    const offset = parseFloat(style.outlineOffset);
    const reach = offset + limits.ring - 0.5;
    const { left, right, top, bottom } = box(element);
    const free = room(around(element).find(cuts));
    const least = Math.min(
      left - free.left, free.right - right, top - free.top, free.bottom - bottom,
    );
    if (least < reach) say(element, `${least.toFixed(1)} px of room for a focus ring`);
    const [x, y, middle] = [(left + right) / 2, (top + bottom) / 2, offset + width / 2];
    const points = [
      [left - middle, y], [right + middle, y], [x, top - middle], [x, bottom + middle],
    ];
    const ring = colour(style.outlineColor);
    for (const below of points.map((point) => ground(element, point))) {
      const found = contrast(over(ring, below), below);
      if (found < limits.focus) {
        return say(element, `a focus ring with a contrast of ${found.toFixed(1)}`);
      }
    }
  };
  const before = document.activeElement;
  [...document.querySelectorAll(FOCUSABLE)]
    .filter((one) => shown(one) && !one.disabled)
    .forEach(look);
  before === document.body ? document.activeElement.blur() : before.focus({ preventScroll: true });

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
