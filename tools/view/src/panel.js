// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Buttons, the list of objects, keys. What is chosen is written on the root element (data-look, data-wires, ...).

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

// A frame round a dot: "bring it into view".
function frameIcon() {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(svg.namespaceURI, 'path');
  path.setAttribute('d', 'M1 5V1h4M11 1h4v4M15 11v4h-4M5 15H1v-4M8 6a2 2 0 1 1 0 4a2 2 0 1 1 0-4');
  svg.append(path);
  return svg;
}

function section(title, ...children) {
  return [element('h2', {}, title), ...children];
}

/** actions: {id, label, title, key, run, isPressed?}; they are told apart by id. */
export class Panel {
  constructor({title, summary, looks, toggles, views, objects, keys, onCover}) {
    this.panel = document.getElementById('panel');
    this.menu = document.getElementById('menu');
    this.help = document.getElementById('help');
    this.actions = [...looks, ...toggles, ...views];
    this.buttons = new Map();
    const buttons = (actions) => element('div', {class: 'buttons'}, ...actions.map((action) => this.button(action)));
    this.panel.append(
      element('h1', {}, title), element('p', {}, summary), ...section('Look', buttons(looks)),
      ...section('Show', buttons(toggles)), ...section('View', buttons(views)),
      ...section('Objects', ...objects.map((object) => this.objectRow(object))));
    this.help.append(
      element('table', {}, ...[...this.actions.map(({key, title: what}) => [key, what]), ...keys].map(
        ([key, what]) => element('tr', {}, element('td', {}, key), element('td', {}, what)))),
      element('form', {method: 'dialog'}, element('button', {}, 'Close')));
    this.menu.addEventListener('click', () => this.toggle());
    this.onCover = onCover;
    new ResizeObserver(() => this.tellCover()).observe(this.panel);
    addEventListener('resize', () => this.tellCover());
    if (matchMedia('(max-width: 640px)').matches) this.toggle();
    this.refresh();
  }

  button(action) {
    const made = element('button', {type: 'button', id: action.id, title: `${action.title} (${action.key})`,
                                    onclick: () => this.run(action)}, action.label);
    this.buttons.set(action.id, made);
    return made;
  }

  objectRow({name, triangles, show, frame}) {
    const box = element('input', {type: 'checkbox', onchange: () => show(box.checked)});
    box.checked = true;
    return element('div', {class: 'row'},
                   element('label', {title: name}, box, element('span', {}, name), element('small', {}, triangles)),
                   element('button', {type: 'button', title: `Bring ${name} into view`, 'aria-label': `Bring ${name} into view`, onclick: frame}, frameIcon()));
  }

  run(action) {
    action.run();
    this.refresh();
  }

  refresh() {
    for (const action of this.actions) {
      if (action.isPressed) this.buttons.get(action.id).setAttribute('aria-pressed', action.isPressed());
      if (action.isUsable) this.buttons.get(action.id).disabled = !action.isUsable();
    }
  }

  toggle() {
    this.panel.hidden = !this.panel.hidden;
    this.menu.setAttribute('aria-expanded', !this.panel.hidden);
    this.tellCover();
  }

  /** How much of the window's right side and bottom the panel takes. */
  tellCover() {
    const {width, height} = this.panel.getBoundingClientRect();
    const isSheet = width > 0.6 * innerWidth;
    this.onCover(this.panel.hidden || isSheet ? 0 : width, !this.panel.hidden && isSheet ? height : 0);
  }

  /** True: the key was for one of the buttons, or for the panel. */
  press(key) {
    const action = this.actions.find((one) => one.key.toLowerCase() === key.toLowerCase());
    if (action && !this.buttons.get(action.id).disabled) this.run(action);
    else if (key.toLowerCase() === 'm') this.toggle();
    else if (key === '?') this.help.open ? this.help.close() : this.help.showModal();
    else return false;
    return true;
  }
}
