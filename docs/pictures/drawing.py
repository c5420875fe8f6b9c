"""What the pictures of these pages are drawn with: shapes, text and plots as SVG."""

import html
import math

BLUE, GREY, ORANGE, GREEN, RED, DARK = "#1f6f8b", "#8a94a0", "#c65d21", "#1e8449", "#c0392b", "#3c444d"


class Drawing:
    """Shapes on white ground, so that it can be read on a dark page as well."""

    def __init__(self, width, height, title):
        self.width, self.height, self.title = width, height, title
        self.parts = []

    def add(self, element, content="", **attributes):
        names = "".join(f' {name.rstrip("_").replace("_", "-")}="{value}"'
                        for name, value in attributes.items())
        self.parts.append(f"<{element}{names}>{content}</{element}>" if content
                          else f"<{element}{names}/>")

    def text(self, x, y, words, **attributes):
        self.add("text", html.escape(words), x=round(x, 1), y=round(y, 1), **attributes)

    def line(self, a, b, **attributes):
        self.add("line", x1=round(a[0], 1), y1=round(a[1], 1), x2=round(b[0], 1), y2=round(b[1], 1),
                 **attributes)

    def polyline(self, points, **attributes):
        self.add("polyline", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in points), fill="none",
                 **attributes)

    def polygon(self, points, **attributes):
        self.add("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in points), **attributes)

    def dot(self, at, radius, **attributes):
        self.add("circle", cx=round(at[0], 1), cy=round(at[1], 1), r=radius, **attributes)

    def arrow(self, a, b, colour=DARK, width=2):
        """From a to b, with its tip at b."""
        length = math.dist(a, b)
        along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        size = 3 + 2 * width
        back = (b[0] - size * along[0], b[1] - size * along[1])
        side = (-0.45 * size * along[1], 0.45 * size * along[0])
        self.line(a, back, stroke=colour, stroke_width=width)
        self.polygon([b, (back[0] + side[0], back[1] + side[1]),
                      (back[0] - side[0], back[1] - side[1])], fill=colour)

    def write(self, file):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                'font-family="Helvetica, Arial, sans-serif" font-size="13">\n'
                f"<title>{html.escape(self.title)}</title>\n"
                f'<rect width="{self.width}" height="{self.height}" rx="6" fill="#ffffff"/>\n')
        file.write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


class Plot:
    """A frame with axes inside a drawing: values of x over y in a rectangle (left, top, right,
    bottom)."""

    def __init__(self, drawing, rectangle, x_range, y_range):
        self.drawing, self.x_range, self.y_range = drawing, x_range, y_range
        self.left, self.top, self.right, self.bottom = rectangle

    def at(self, x, y):
        share = (x - self.x_range[0]) / (self.x_range[1] - self.x_range[0])
        rise = (y - self.y_range[0]) / (self.y_range[1] - self.y_range[0])
        return (self.left + share * (self.right - self.left),
                self.bottom - rise * (self.bottom - self.top))

    def frame(self, title, x_ticks, y_ticks, x_name=""):
        draw = self.drawing
        for y in y_ticks:
            draw.line(self.at(self.x_range[0], y), self.at(self.x_range[1], y), stroke="#e3e6ea")
            draw.text(self.left - 6, self.at(0, y)[1] + 4, f"{y:g}", text_anchor="end", fill=DARK)
        for x in x_ticks:
            at = self.at(x, self.y_range[0])
            draw.line(at, (at[0], at[1] + 4), stroke=DARK)
            draw.text(at[0], at[1] + 17, f"{x:g}", text_anchor="middle", fill=DARK)
        draw.line((self.left, self.bottom), (self.right, self.bottom), stroke=DARK)
        draw.text(self.left, self.top - 8, title, font_weight="bold", fill=DARK)
        draw.text(self.right, self.bottom + 32, x_name, text_anchor="end", fill=DARK)

    def curve(self, xs, ys, **attributes):
        inside = [(x, y) for x, y in zip(xs, ys) if self.x_range[0] <= x <= self.x_range[1]]
        self.drawing.polyline([self.at(x, y) for x, y in inside], **attributes)

    def dots(self, xs, ys, radius, **attributes):
        for x, y in zip(xs, ys):
            if self.x_range[0] <= x <= self.x_range[1]:
                self.drawing.dot(self.at(x, y), radius, **attributes)

    def shade(self, x0, x1, colour):
        left, right = self.at(x0, 0)[0], self.at(x1, 0)[0]
        self.drawing.add("rect", x=round(left, 1), y=self.top, width=round(right - left, 1),
                         height=self.bottom - self.top, fill=colour)
