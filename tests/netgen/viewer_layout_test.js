// Appended to a page of `epsnet view` that is shown in a frame of some size: where things are, and whether they can be read. The page around it reads the result.
{
  const failures = [];
  const size = `${innerWidth} x ${innerHeight}`;
  const expect = (holds, what) => { if (!holds) failures.push(`${size}: ${what}`); };
  const byId = id => document.getElementById(id);
  const isShown = element => element !== null && element.getClientRects().length > 0;
  const box = element => element.getBoundingClientRect();
  const meet = (p, q) => Math.min(p.right, q.right) - Math.max(p.left, q.left) > 0 && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 0;
  const isSmall = innerWidth <= 720;

  // What is over the picture is within it, and not over something else.
  const checkPlaces = state => {
    expect(document.documentElement.scrollWidth <= innerWidth, `${state}: the page is wider than the screen`);
    const picture = box(byId('view')), cards = ['legend', 'status', 'tools'].map(byId).filter(isShown);
    for (const card of cards) {
      const {left, right, top, bottom} = box(card);
      expect(left >= picture.left && right <= picture.right && top >= picture.top && bottom <= picture.bottom, `${state}: ${card.id} leaves the picture`);
      for (const other of cards) expect(other === card || !meet(box(card), box(other)), `${state}: ${card.id} is over ${other.id}`);
    }
    for (const button of document.querySelectorAll('button'))
      if (isShown(button)) expect(Math.min(box(button).width, box(button).height) >= 24, `${state}: ${button.id} is too small for a finger`);
    for (const button of document.querySelectorAll('#tools button'))
      if (isShown(button)) expect(Math.min(box(button).width, box(button).height) >= 44, `${state}: ${button.id} is too small for a thumb`);
  };

  const channelsOf = colour => colour.match(/[0-9.]+/g).map(Number);
  const luminanceOf = rgb => {
    const [r, g, b] = rgb.map(x => x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  // Contrast of text with the colour behind it, as the Web Content Accessibility Guidelines define it. What lies over the picture needs a colour of its own.
  const checkContrast = state => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    let count = 0;
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const element = node.parentElement;
      if (node.data.trim() === '' || !isShown(element) || element.closest('script, noscript, option') || element.disabled) continue;
      let behind = element;
      while (behind !== null && behind.localName !== 'main' && channelsOf(getComputedStyle(behind).backgroundColor)[3] === 0) behind = behind.parentElement;
      const what = `${state}: "${node.data.trim().slice(0, 20)}"`;
      if (behind === null || behind.localName === 'main') {
        expect(false, `${what} has nothing behind it`);
        continue;
      }
      const a = luminanceOf(channelsOf(getComputedStyle(element).color).slice(0, 3)), b = luminanceOf(channelsOf(getComputedStyle(behind).backgroundColor).slice(0, 3));
      const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      expect(contrast >= 4.5, `${what} has a contrast of ${contrast.toFixed(2)}`);
      ++count;
    }
    expect(count > 5, `${state}: only ${count} texts`);
  };

  try {
    expect(byId('panel').hidden === (isSmall || innerHeight <= 480), 'the panel is open where there is no room for it, or closed where there is');
    byId('panel').hidden || byId('toggle').click();
    const folds = innerWidth <= 860;
    expect(byId('legend').open === !folds && isShown(byId('legend').querySelector('summary')) === folds, 'the legend is folded where there is room for it, or open where there is none');
    for (const scheme of ['light', 'dark']) {
      byId('scheme').value = scheme;
      byId('scheme').dispatchEvent(new Event('change'));
      const closed = box(byId('view'));
      expect(closed.width === innerWidth && closed.height >= innerHeight - 64, `the picture has ${closed.width} x ${closed.height} pixels`);
      checkPlaces(`${scheme}, closed`);
      checkContrast(`${scheme}, closed`);
      byId('toggle').click();
      const open = box(byId('view')), panel = box(byId('panel'));
      expect(!meet(open, panel), 'the panel is over the picture');
      expect(isSmall ? open.width === innerWidth && open.height >= 0.4 * innerHeight : open.width >= innerWidth - 360, `beside the panel the picture has ${open.width} x ${open.height} pixels`);
      expect(panel.bottom <= innerHeight + 1 && byId('panel').scrollWidth <= byId('panel').clientWidth, 'the panel does not fit');
      checkPlaces(`${scheme}, open`);
      checkContrast(`${scheme}, open`);
      byId('toggle').click();
    }
  } catch (error) {
    expect(false, error);
  }
  document.body.dataset.failures = failures.join('; ');
}
