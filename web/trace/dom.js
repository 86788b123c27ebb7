// Elements with text: names from files never become markup.

function filled(node, properties, children) {
  for (const [name, value] of Object.entries(properties)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.flat());
  return node;
}

export const element = (tag, properties = {}, ...children) =>
  filled(document.createElement(tag), properties, children);

export const drawn = (tag, properties = {}, ...children) =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", tag), properties, children);

export const byId = (id) => document.getElementById(id);
