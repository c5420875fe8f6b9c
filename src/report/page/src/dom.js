/** An element with attributes and children; texts stay texts, whatever they hold. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'onclick') made.addEventListener('click', value);
    else if (value !== undefined && value !== null) made.setAttribute(name, value);
  }
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return made;
}

/** The value of a style sheet's variable now. */
export const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
