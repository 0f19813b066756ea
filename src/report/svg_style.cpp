#include "report/svg.hpp"

namespace drape::report {

// Eight colours for colour-blind readers (Okabe and Ito); black is the text colour.
std::string_view svgStyle() {
  return R"(svg.drape { color-scheme: light dark; --ink: #222; --faint: #ddd; --paper: #fff;
  --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #b0569a; --c4: #222; --c5: #b98000; --c6: #2c8fc4; --c7: #847c00;
  --good: #bfe5cf; --doubtful: #ffe39a; --bad: #f6b5a8; --dull: #c3d6ee; --none: #eee;
  font-family: sans-serif; font-size: 12px; fill: var(--ink); max-width: 100%; height: auto; }
@media screen and (prefers-color-scheme: dark) {
  svg.drape { --ink: #ddd; --faint: #444; --paper: #16181c;
    --c0: #4aa8e0; --c1: #ff8c42; --c2: #35c99b; --c3: #e08fc8; --c4: #ddd; --c5: #f0b840; --c6: #8fd0f5; --c7: #cfc74a;
    --good: #1f5a3c; --doubtful: #6b5410; --bad: #7a2c1e; --dull: #28466b; --none: #2a2d33; } }
svg.drape .title { font-size: 14px; font-weight: bold; }
svg.drape .grid { stroke: var(--faint); stroke-width: 1; }
svg.drape .small { stroke: var(--ink); stroke-width: 0.7; }
svg.drape .frame { stroke: var(--ink); fill: none; }
svg.drape .curve { fill: none; stroke-width: 1.6; }
svg.drape .front { fill: none; stroke: var(--ink); stroke-opacity: 0.18; stroke-width: 9; stroke-linejoin: round; stroke-linecap: round; }
svg.drape .level { fill: none; stroke: var(--ink); stroke-width: 1.2; stroke-dasharray: 8 5; }
svg.drape .band { fill-opacity: 0.2; stroke: none; }
svg.drape .hollow { fill: var(--paper); stroke-width: 1.6; }
svg.drape .cross { fill: none; stroke-width: 1.8; }
svg.drape .line0 { stroke: var(--c0); } svg.drape .fill0 { fill: var(--c0); }
svg.drape .line1 { stroke: var(--c1); } svg.drape .fill1 { fill: var(--c1); }
svg.drape .line2 { stroke: var(--c2); } svg.drape .fill2 { fill: var(--c2); }
svg.drape .line3 { stroke: var(--c3); } svg.drape .fill3 { fill: var(--c3); }
svg.drape .line4 { stroke: var(--c4); } svg.drape .fill4 { fill: var(--c4); }
svg.drape .line5 { stroke: var(--c5); } svg.drape .fill5 { fill: var(--c5); }
svg.drape .line6 { stroke: var(--c6); } svg.drape .fill6 { fill: var(--c6); }
svg.drape .line7 { stroke: var(--c7); } svg.drape .fill7 { fill: var(--c7); }
svg.drape .dash1 { stroke-dasharray: 7 3; } svg.drape .dash2 { stroke-dasharray: 2 3; }
svg.drape .dash3 { stroke-dasharray: 9 3 2 3; }
svg.drape .good { fill: var(--good); } svg.drape .doubtful { fill: var(--doubtful); } svg.drape .bad { fill: var(--bad); }
svg.drape .dull { fill: var(--dull); } svg.drape .none { fill: var(--none); }
)";
}

std::string svgFile(std::string_view svg) {
  // The style is inserted after the opening tag of the picture.
  const std::size_t end = svg.find('>') + 1;
  std::string file = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  file += svg.substr(0, end);
  file += "\n<style>\n";
  file += svgStyle();
  file += "</style>";
  file += svg.substr(end);
  return file;
}

}  // namespace drape::report
