#include "image/caption.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace marrow::tools {
namespace {

// Strokes of a glyph, parted by spaces: points as two hexadecimal digits x, y. "~" makes a stroke a smooth curve,
// closed if it ends where it begins. The baseline is y = 4, small letters reach 10 (A), capitals 13 (D), descenders 0.
constexpr const char* kGlyphs[] = {
    /* ! */ "1D17 1414",
    /* " */ "0D0B 2D2B",
    /* # */ "1D14 5D54 0A6A 0767",
    /* $ */ "~6B5C3D1C0B1A39586655341506 3F32",
    /* % */ "~1D2C1B0C1D ~5766554657 046D",
    /* & */ "641B ~1B1C3D4C4B1907153465",
    /* ' */ "1D1B",
    /* ( */ "~2E0B0623",
    /* ) */ "~0E2B2603",
    /* * */ "3C38 1B59 5B19",
    /* + */ "0868 3B35",
    /* , */ "1512",
    /* - */ "1848",
    /* . */ "1414",
    /* / */ "046D",
    /* 0 */ "~695C3D1C09081534556869",
    /* 1 */ "1B3D 3D34",
    /* 2 */ "~0A1C3D5C5A48 4804 0464",
    /* 3 */ "~0B1C3D5C5A39 ~39586655341506",
    /* 4 */ "4D07 0767 4D44",
    /* 5 */ "5D1D 1D09 ~093A5967553415",
    /* 6 */ "~5D2B07 ~67593A190715345567",
    /* 7 */ "0D6D 6D24",
    /* 8 */ "~3D5C5A391A1C3D ~395866553415061839",
    /* 9 */ "~6A5C3D1C0A1837586A ~6A4614",
    /* : */ "1414 1919",
    /* ; */ "1512 1919",
    /* < */ "5B08 0855",
    /* = */ "0969 0666",
    /* > */ "0B58 5805",
    /* ? */ "~0B1C3D5C6A4937 3736 3434",
    /* @ */ "~5948394857 ~576769 ~695C3D1C09081534",
    /* A */ "043D 3D64 1757",
    /* B */ "0D04 0D3D ~3D5C5A39 0939 ~3958665534 0434",
    /* C */ "~6B5C3D1C0A0715345566",
    /* D */ "0D04 0D2D ~2D5C6A675524 0424",
    /* E */ "5D0D 0D04 0454 0949",
    /* F */ "5D0D 0D04 0949",
    /* G */ "~6B5C3D1C0A0715345566 6668 6848",
    /* H */ "0D04 6D64 0969",
    /* I */ "1D14",
    /* J */ "4D47 ~47351405",
    /* K */ "0D04 6D08 2A64",
    /* L */ "0D04 0454",
    /* M */ "040D 0D47 478D 8D84",
    /* N */ "040D 0D64 646D",
    /* O */ "~6A5C3D1C0A07153455676A",
    /* P */ "0D04 0D3D ~3D5C5A39 3909",
    /* Q */ "~6A5C3D1C0A07153455676A 4664",
    /* R */ "0D04 0D3D ~3D5C5A39 3909 3964",
    /* S */ "~6B5C3D1C0B1A39586655341506",
    /* T */ "0D6D 3D34",
    /* U */ "0D07 ~0715345567 676D",
    /* V */ "0D34 346D",
    /* W */ "0D24 244B 4B64 648D",
    /* X */ "0D64 6D04",
    /* Y */ "0D39 6D39 3934",
    /* Z */ "0D6D 6D04 0464",
    /* [ */ "2E0E 0E02 0222",
    /* \ */ "0D64",
    /* ] */ "0E2E 2E22 2202",
    /* ^ */ "0A3D 3D6A",
    /* _ */ "0363",
    /* ` */ "0D2B",
    /* a */ "~67593A190715345567 6A64",
    /* b */ "0D04 ~67593A190715345567",
    /* c */ "~593A1907153455",
    /* d */ "~67593A190715345567 6D64",
    /* e */ "0767 ~67593A1907153455",
    /* f */ "~5C4D3D2C2A 2A24 0A4A",
    /* g */ "~67593A190715345567 6A63 ~63513011",
    /* h */ "0D04 ~07193A5967 6764",
    /* i */ "1A14 1D1D",
    /* j */ "2A22 ~221100 2D2D",
    /* k */ "0D04 5A07 2854",
    /* l */ "1D14",
    /* m */ "0A04 ~07192A3947 4744 ~47596A7987 8784",
    /* n */ "0A04 ~07193A5967 6764",
    /* o */ "~67593A190715345567",
    /* p */ "0A00 ~67593A190715345567",
    /* q */ "6A60 ~67593A190715345567",
    /* r */ "0A04 ~07182A4A",
    /* s */ "~593A191837565534 ~341505",
    /* t */ "2D26 ~26253444 0A4A",
    /* u */ "0A07 ~0715345567 6A64",
    /* v */ "0A34 346A",
    /* w */ "0A24 244A 4A64 648A",
    /* x */ "0A64 6A04",
    /* y */ "0A34 6A20",
    /* z */ "0A6A 6A04 0464",
    /* { */ "~3E2C2A08262432",
    /* | */ "1E12",
    /* } */ "~0E1C1A38161402",
    /* ~ */ "~0819384756"};

constexpr float kCapUnits = 9;        // baseline to capitals
constexpr float kSpacing = 2.6f;      // units between glyphs
constexpr float kSpace = 4.2f;        // units of a space
constexpr float kHalfStroke = 0.62f;  // units

struct Point {
  float x, y;
};
using Stroke = std::vector<Point>;

float hex(char c) {
  return static_cast<float>(c >= 'A' ? c - 'A' + 10 : c - '0');
}

const char* glyph(char c) {
  return c > ' ' && c <= '~' ? kGlyphs[c - '!'] : kGlyphs['?' - '!'];
}

// Catmull-Rom through the points.
Stroke smooth(const Stroke& points) {
  constexpr int kPieces = 6;
  const int count = static_cast<int>(points.size());
  const bool closed = count > 2 && points.front().x == points.back().x && points.front().y == points.back().y;
  const auto at = [&](int i) {
    if (closed) return points[static_cast<std::size_t>((i + count - 1) % (count - 1))];
    return points[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
  };
  Stroke out{points.front()};
  for (int i = 0; i + 1 < count; ++i) {
    const Point a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    for (int piece = 1; piece <= kPieces; ++piece) {
      const float t = static_cast<float>(piece) / kPieces;
      const auto curve = [t](float p, float q, float r, float s) {
        return q + 0.5f * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)));
      };
      out.push_back({curve(a.x, b.x, c.x, d.x), curve(a.y, b.y, c.y, d.y)});
    }
  }
  return out;
}

std::vector<Stroke> strokes(const char* text) {
  std::vector<Stroke> out;
  while (*text != '\0') {
    const bool curved = *text == '~';
    if (curved) ++text;
    Stroke stroke;
    for (; *text != '\0' && *text != ' '; text += 2) stroke.push_back({hex(text[0]), hex(text[1])});
    out.push_back(curved ? smooth(stroke) : stroke);
    while (*text == ' ') ++text;
  }
  return out;
}

float right_edge(const std::vector<Stroke>& glyph_strokes) {
  float right = 0;
  for (const Stroke& stroke : glyph_strokes) {
    for (const Point p : stroke) right = std::max(right, p.x);
  }
  return right;
}

float distance(Point p, Point a, Point b) {
  const float dx = b.x - a.x, dy = b.y - a.y;
  const float length2 = dx * dx + dy * dy;
  const float t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0f, 1.0f) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// origin: where x = 0 of the baseline lies, pixels; unit: pixels a grid unit.
void draw_glyph(Image& image, Point origin, float unit, Rgb colour, const std::vector<Stroke>& glyph_strokes) {
  const float half = std::max(kHalfStroke * unit, 0.45f);
  const int left = static_cast<int>(std::floor(origin.x - 2 * half - 1));
  const int right = static_cast<int>(std::ceil(origin.x + right_edge(glyph_strokes) * unit + 2 * half + 1));
  const int top = static_cast<int>(std::floor(origin.y - 12 * unit - 2));
  const int bottom = static_cast<int>(std::ceil(origin.y + 5 * unit + 2));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const Point p{(static_cast<float>(x) + 0.5f - origin.x) / unit,
                    4 - (static_cast<float>(y) + 0.5f - origin.y) / unit};
      float nearest = 1e9f;
      for (const Stroke& stroke : glyph_strokes) {
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
          nearest = std::min(nearest, distance(p, stroke[i], stroke[i + 1]));
      }
      const float coverage = half + 0.5f - nearest * unit;
      if (coverage > 0) blend(image, x, y, colour, coverage);
    }
  }
}

template <class Visit>
float lay_out(float x, float unit, std::string_view text, const Visit& visit) {
  for (const char c : text) {
    if (c == ' ') {
      x += kSpace * unit;
      continue;
    }
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // the rest of a UTF-8 character
    const std::vector<Stroke> glyph_strokes = strokes(glyph(c));
    visit(x, glyph_strokes);
    x += (right_edge(glyph_strokes) + kSpacing) * unit;
  }
  return x;
}

}  // namespace

float draw_text(Image& image, float x, float y, float cap_height, Rgb colour, std::string_view text) {
  const float unit = cap_height / kCapUnits;
  return lay_out(x, unit, text, [&](float at, const std::vector<Stroke>& glyph_strokes) {
    draw_glyph(image, {at, y}, unit, colour, glyph_strokes);
  });
}

float text_width(float cap_height, std::string_view text) {
  const float unit = cap_height / kCapUnits;
  return std::max(0.0f, lay_out(0, unit, text, [](float, const std::vector<Stroke>&) {}) - kSpacing * unit);
}

}  // namespace marrow::tools
