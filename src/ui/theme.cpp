#include "ui/theme.hpp"

#include "ui/embedded_fonts.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace drape::ui {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0F) {
  return {static_cast<float>((hex >> 16U) & 0xFFU) / 255.0F, static_cast<float>((hex >> 8U) & 0xFFU) / 255.0F,
          static_cast<float>(hex & 0xFFU) / 255.0F, alpha};
}

void applySizes(ImGuiStyle& style) {
  style.WindowPadding = {14.0F, 12.0F};
  style.FramePadding = {8.0F, 4.0F};
  style.ItemSpacing = {8.0F, 6.0F};
  style.ItemInnerSpacing = {6.0F, 4.0F};
  style.IndentSpacing = 14.0F;
  style.ScrollbarSize = 11.0F;
  style.GrabMinSize = 5.0F;
  style.WindowRounding = 0.0F;
  style.PopupRounding = 6.0F;
  style.FrameRounding = 5.0F;
  style.GrabRounding = 2.5F;
  style.ScrollbarRounding = 6.0F;
  style.WindowBorderSize = 0.0F;
  style.PopupBorderSize = 1.0F;
  style.FrameBorderSize = 0.0F;
}

void applyColours(ImGuiStyle& style) {
  const Palette& colours = palette();
  auto& slot = style.Colors;
  slot[ImGuiCol_Text] = colours.text;
  slot[ImGuiCol_TextDisabled] = colours.muted;
  slot[ImGuiCol_WindowBg] = colours.panel;
  slot[ImGuiCol_ChildBg] = rgb(0x000000, 0.0F);
  slot[ImGuiCol_PopupBg] = rgb(0x242933);
  slot[ImGuiCol_Border] = colours.line;
  slot[ImGuiCol_FrameBg] = colours.field;
  slot[ImGuiCol_FrameBgHovered] = rgb(0x343B49);
  slot[ImGuiCol_FrameBgActive] = rgb(0x3A4252);
  slot[ImGuiCol_ScrollbarBg] = rgb(0x000000, 0.0F);
  slot[ImGuiCol_ScrollbarGrab] = rgb(0x3A4150);
  slot[ImGuiCol_ScrollbarGrabHovered] = rgb(0x4A5264);
  slot[ImGuiCol_ScrollbarGrabActive] = rgb(0x586176);
  slot[ImGuiCol_CheckMark] = colours.accent;
  slot[ImGuiCol_SliderGrab] = colours.accent;
  slot[ImGuiCol_SliderGrabActive] = rgb(0x9CCBFF);
  slot[ImGuiCol_Button] = rgb(0x2F3541);
  slot[ImGuiCol_ButtonHovered] = rgb(0x3A4252);
  slot[ImGuiCol_ButtonActive] = rgb(0x465064);
  slot[ImGuiCol_Header] = rgb(0x000000, 0.0F);
  slot[ImGuiCol_HeaderHovered] = rgb(0x2B303B);
  slot[ImGuiCol_HeaderActive] = rgb(0x333A47);
  slot[ImGuiCol_Separator] = colours.line;
  slot[ImGuiCol_TextSelectedBg] = rgb(0x3D6FA8, 0.7F);
  slot[ImGuiCol_NavHighlight] = colours.accent;
}

}  // namespace

const Palette& palette() {
  static const Palette colours{
      .text = rgb(0xE8EAEE),
      .muted = rgb(0xA3ACBB),
      .accent = rgb(0x6FB3FA),
      .accentFill = rgb(0x34557C),
      .panel = rgb(0x1B1E25),
      .field = rgb(0x292E38),
      .line = rgb(0x323844),
      .good = rgb(0x7CC58E),
      .warning = rgb(0xEDBB5F),
      .error = rgb(0xF58A84),
      .ghost = rgb(0x63D08A),
      .plot = {rgb(0x6FB3FA), rgb(0xF2A65A), rgb(0xC792EA), rgb(0xF2F4F8), rgb(0xF06A8A)},
  };
  return colours;
}

void applyTheme(ImGuiStyle& style, float scale) {
  style = ImGuiStyle();
  applySizes(style);
  applyColours(style);
  style.ScaleAllSizes(scale);
}

UiFonts buildFonts(ImFontAtlas& atlas, float scale, float density) {
  // Latin, Greek, Cyrillic and general punctuation, for file names and units.
  static constexpr std::array<ImWchar, 15> ranges{0x0020, 0x017F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x2010, 0x2027,
                                                  0x2070, 0x209F, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  const std::string_view bytes = embeddedFonts().front().bytes;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 2;
  const auto add = [&](float size) {
    // The atlas frees its copy; it does not own the embedded bytes.
    void* copy = ImGui::MemAlloc(bytes.size());
    std::memcpy(copy, bytes.data(), bytes.size());
    return atlas.AddFontFromMemoryTTF(copy, static_cast<int>(bytes.size()), std::round(size * scale * density), &config,
                                      ranges.data());
  };
  atlas.Clear();
  atlas.TexGlyphPadding = 1;
  const UiFonts fonts{.regular = add(baseFontSize), .title = add(baseFontSize * 1.3F)};
  atlas.Build();
  return fonts;
}

}  // namespace drape::ui
