#include "report/page.hpp"

#include "report/assets.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

void replace(std::string& text, const std::string& mark, const std::string& with) {
  const auto at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), with);
}

// Inside a script no "<" may stand, or "</script>" in a case's text would end it.
std::string safe_in_script(const std::string& json) {
  std::string safe;
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::string navigation(const std::vector<Section>& sections) {
  std::string links;
  for (const Section& s : sections)
    links += element("a", escape(s.title), "href=\"#" + s.id + "\"");
  return links;
}

std::string body(const std::vector<Section>& sections) {
  std::string html;
  for (const Section& s : sections)
    html += element("section", element("h2", escape(s.title)) + s.html, "id=\"" + s.id + "\"");
  return html;
}

}  // namespace

std::string Charts::column(const std::string& name, const std::vector<double>& values) {
  if (known_.insert(name).second) columns_.set(name, Value(values));
  return name;
}

std::string Charts::add(const std::string& id, const std::string& title, Value spec,
                        const std::string& caption) {
  spec.set("title", title);
  charts_.set(id, std::move(spec));
  std::string html = element("h3", escape(title)) + element("div", "", "class=\"plot\"");
  if (!caption.empty()) html += element("figcaption", caption);
  return element("figure", html, "class=\"chart\" data-chart=\"" + id + "\"");
}

std::string Charts::to_json() const {
  Value data;
  data.set("columns", columns_);
  data.set("charts", charts_);
  return report::to_json(data);
}

std::string absent(const std::string& reason) {
  return element("p", escape(reason), "class=\"absent\"");
}

std::string assemble(const std::string& title, const std::string& subtitle,
                     const std::vector<Section>& sections, const Charts& charts) {
  std::string html(asset_frame());
  replace(html, "{{title}}", escape(title));
  replace(html, "{{style}}", std::string(asset_style()));
  replace(html, "{{heading}}", escape(title));
  replace(html, "{{subtitle}}", escape(subtitle));
  replace(html, "{{navigation}}", navigation(sections));
  // Last what may hold anything, so that no mark is looked for inside it.
  const std::string scripts =
      element("script", std::string(asset_d3())) + element("script", std::string(asset_script()));
  const std::string data = element("script", safe_in_script(charts.to_json()),
                                   "type=\"application/json\" id=\"pmr-data\"");
  replace(html, "{{scripts}}", data + scripts);
  replace(html, "{{body}}", body(sections));
  return html;
}

}  // namespace pmr::report
