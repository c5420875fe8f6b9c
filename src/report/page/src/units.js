export const degree = Math.PI / 180;

/** The coordinates of a deviation, and how they are shown. */
export const coordinates = [
  { name: 'x', unit: 'mm', factor: 1e3, colour: '#3d7dca' },
  { name: 'y', unit: 'mm', factor: 1e3, colour: '#d08a1e' },
  { name: 'z', unit: 'mm', factor: 1e3, colour: '#4a9e55' },
  { name: 'rx', unit: 'deg', factor: 1 / degree, colour: '#a05fc4' },
  { name: 'ry', unit: 'deg', factor: 1 / degree, colour: '#c9524a' },
  { name: 'rz', unit: 'deg', factor: 1 / degree, colour: '#2a9aa3' },
];

/** Of a joint's derivative: 'rad/s^2'. */
export function unitOf(joint, derivative) {
  const base = joint.prismatic ? 'm' : 'rad';
  return ['', '/s', '/s\u00b2', '/s\u00b3'].map((per) => base + per)[derivative];
}

/** A length in mm or an angle in deg, to a thousandth. */
export function fixed(value, isSigned = false) {
  const text = Math.abs(value) < 5e-4 ? '0' : String(Number(value.toFixed(3)));
  return isSigned && value >= 5e-4 ? `+${text}` : text;
}

/** A number for people: four significant digits; '-' for none. */
export function shown(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '-';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) return value.toExponential(2);
  return String(Number(value.toPrecision(digits)));
}
