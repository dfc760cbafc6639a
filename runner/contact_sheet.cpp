#include "runner/contact_sheet.hpp"

namespace lt {

namespace {

constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Tracing Light: contact sheet</title>
<style>
:root { --paper: #f6f5f2; --ink: #1d1d20; --soft: #5c5c66; --card: #fff; --line: #dddbd4; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #131316; --ink: #ececf0; --soft: #a3a3b0; --card: #1d1d22; --line: #33333c; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1360px; padding: 2rem 1.25rem 4rem; background: var(--paper);
  color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 1.9rem; letter-spacing: -0.02em; }
h2 { margin: 2.5rem 0 1rem; font-size: 1.25rem; border-bottom: 1px solid var(--line);
  padding-bottom: 0.4rem; }
header p, .details { color: var(--soft); margin: 0.25rem 0 0; }
.sheet { display: grid; gap: 1.25rem; align-items: start;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 19rem), 1fr)); }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  overflow: hidden; }
figure a { display: block; background: #808080; }
figure a:focus-visible { outline: 3px solid #3b82f6; outline-offset: -3px; }
figure a.plot { background: none; padding: 0.5rem; }
img { display: block; width: 100%; height: auto; }
figcaption { padding: 0.8rem 1rem 1rem; }
figcaption strong { display: block; }
figcaption p { margin: 0; }
.details { font-size: 0.85rem; }
code { display: block; margin-top: 0.6rem; padding: 0.5rem 0.6rem; border-radius: 6px;
  background: var(--paper); font: 0.78rem/1.45 ui-monospace, monospace; overflow-wrap: anywhere;
  user-select: all; }
@media print { body { background: none; } figure { break-inside: avoid; } }
</style>
</head>
<body>
<header>
<h1>Contact sheet</h1>
)";

std::string figure(const SheetPicture& picture) {
  const bool is_plot = picture.link.ends_with(".svg");
  const std::string link = escaped_html(picture.link);
  std::string html = "<figure>\n<a href=\"" + link + "\"" + (is_plot ? " class=\"plot\"" : "") +
                     "><img src=\"" + link + "\" alt=\"" + escaped_html(picture.caption) +
                     "\" loading=\"lazy\"></a>\n<figcaption>";
  if (!picture.title.empty()) html += "<strong>" + escaped_html(picture.title) + "</strong>";
  html += "<p>" + escaped_html(picture.caption) + "</p>\n<p class=\"details\">" +
          escaped_html(picture.details) + "</p>\n<code>" + escaped_html(picture.command) +
          "</code></figcaption>\n</figure>\n";
  return html;
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string contact_sheet(const std::vector<SheetPicture>& pictures) {
  std::string html(head);
  html += "<p>" + std::to_string(pictures.size()) +
          " pictures. Each was made by the command below it; click one to see it at full size.</p>"
          "\n</header>\n<main>\n";
  std::string chapter;
  for (const SheetPicture& picture : pictures) {
    if (picture.chapter != chapter) {
      if (!chapter.empty()) html += "</div>\n</section>\n";
      chapter = picture.chapter;
      html += "<section>\n<h2>" + escaped_html(chapter) + "</h2>\n<div class=\"sheet\">\n";
    }
    html += figure(picture);
  }
  if (!chapter.empty()) html += "</div>\n</section>\n";
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace lt
