#include "scenario_support.hpp"
#include "sim/scenario/xml_document.hpp"
#include "support/catch.hpp"

using namespace nadir;

namespace {

/// `line:column: message` of what is wrong with the XML, or empty.
std::string problem(const std::string& text) {
  try {
    static_cast<void>(sim::parse_xml(sim::SourceText{"t.xml", text}));
    return {};
  } catch (const InputError& error) {
    REQUIRE(error.issues().size() == 1);
    const InputIssue& issue = error.issues()[0];
    return std::to_string(issue.where.line) + ":" + std::to_string(issue.where.column) + ": " +
           issue.message;
  }
}

std::string nested(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += "<a>";
  for (int i = 0; i < depth; ++i) text += "</a>";
  return text;
}

}  // namespace

TEST_CASE("well-formed XML is taken", "[scenario][xml]") {
  const auto text = GENERATE(as<std::string>{}, "<a/>", "<?xml version='1.0'?>\n<a></a>\n",
                             "<?xml version=\"1.0\" encoding=\"utf-8\" standalone='yes'?><a/>",
                             "<?editor on?><!-- c --><a b = 'x>y' c='&lt;&#65;&#x41;' /><!-- d -->",
                             "\xEF\xBB\xBF<a>\r\n<b/>\r\n</a >", "<a>text <b/> more</a>",
                             "<a><![CDATA[<&]]></a>", "<\xC3\xA4 \xC3\xB6='\xE2\x82\xAC'/>");
  CAPTURE(text);
  CHECK(problem(text).empty());
}

TEST_CASE("XML that is not well-formed is refused at the place of the slip", "[scenario][xml]") {
  const auto [text, expected] = GENERATE(table<std::string, std::string>({
      {"", "1:1: the file holds no XML element"},
      {" \n <!-- only this -->", "1:1: the file holds no XML element"},
      {"hello", "1:1: text outside the root element"},
      {"<a>\n  <b>\n</a>", "3:1: </a> where </b> is due for <b> of line 2"},
      {"<a>\n  <b>", "2:3: <b> is never closed"},
      {"<a/>\n<b/>", "2:1: a second root element <b>; the first, <a>, ends before it"},
      {"<a/> x", "1:6: text outside the root element"},
      {"</a>", "1:1: </a> closes nothing"},
      {"<a b='1' b='2'/>", "1:10: <a> has attribute \"b\" twice"},
      {"<a b/>", "1:5: expected = after the attribute's name \"b\""},
      {"<a b=1/>", "1:6: expected \"...\" as the value of \"b\""},
      {"<a b='1/>", "1:6: the value of \"b\" is never closed"},
      {"<a b='1>\n<c d='2'/>", "2:1: the value of \"b\" holds <"},
      {"<a b='1'c='2'/>", "1:9: expected a blank, > or /> in the tag <a>"},
      {"<a b='&nope;'/>", "1:7: & starts no known character entity"},
      {"<a b='x & y'/>", "1:9: & starts no known character entity"},
      {"<a b='&#0;'/>", "1:7: & starts no known character entity"},
      {"<a b='&#x110000;'/>", "1:7: & starts no known character entity"},
      {"<a b='&#-5;'/>", "1:7: & starts no known character entity"},
      {"<a>&</a>", "1:4: & starts no known character entity"},
      {"<a>]]></a>", "1:4: ]]> may not stand in text"},
      {"<a><!-- x -- y --></a>", "1:11: a comment may not hold --"},
      {"<a><!-- x", "1:4: this comment is never closed"},
      {"<a><![CDATA[ x</a>", "1:4: this CDATA section is never closed"},
      {"<!DOCTYPE a [<!ENTITY x 'y'>]><a/>", "1:1: only elements and comments may stand here"},
      {"<a><?p?></a>", "1:4: processing instructions may only stand before the root and comments"},
      {" <?xml version='1.0'?><a/>",
       "1:2: the XML declaration may only stand at the file's very start"},
      {"<?xml version='1.0' encoding='latin1'?><a/>",
       "1:21: the encoding is \"latin1\", expected UTF-8"},
      {"<?xml version='2.0'?><a/>", "1:7: expected XML version 1.0"},
      {"<?xml encoding='UTF-8'?><a/>", "1:7: the XML declaration may not hold \"encoding\" here"},
      {"<?xml ?><a/>", "1:7: expected <?xml version=\"1.0\" encoding=\"UTF-8\"?>"},
      {"<a>\n<1b/></a>", "2:2: expected the name of an element after <"},
      {"<a ='1'/>", "1:4: expected the name of an attribute, > or />"},
      {"<", "1:2: expected the name of an element after <"},
      {"<a", "1:3: expected a blank, > or /> in the tag <a>"},
      {"<a></a", "1:7: expected > to end </a"},
      {std::string{"<a b='x\0y'/>", 12}, "1:8: XML may not hold control character number 0"},
      {"<a>\x01</a>", "1:4: XML may not hold control character number 1"},
      {"<a>\xFF</a>", "1:4: this byte is not part of UTF-8 text"},
      {"<a>\xC0\x80</a>", "1:4: this byte is not part of UTF-8 text"},
      {"<a>\xED\xA0\x80</a>", "1:4: XML may not hold control character number 55296"},
      {"<a>\xE2\x82", "1:4: this byte is not part of UTF-8 text"},
      {nested(65), "1:193: elements are nested too deeply"},
  }));
  CAPTURE(text);
  CHECK(problem(text) == expected);
}

TEST_CASE("elements and attributes know their places", "[scenario][xml]") {
  const sim::SourceText source{"t.xml",
                               "<?xml version='1.0'?>\n<!-- <no> -->\n<a x='1'\n"
                               "   y='a &lt; &#66;'>\n\t<b/>text<c z=\"2\"/>\n</a>\n"};
  const sim::XmlElement a = sim::parse_xml(source);
  const auto place = [&](std::size_t offset) {
    const SourceLocation at = source.locate(offset);
    return std::pair{at.line, at.column};
  };
  CHECK(place(a.offset) == std::pair{3, 1});
  REQUIRE(a.attributes.size() == 2);
  CHECK(place(a.attributes[1].offset) == std::pair{4, 4});
  CHECK(a.attributes[1].value == "a < B");
  REQUIRE(a.children.size() == 2);
  CHECK(place(a.children[0].offset) == std::pair{5, 2});
  CHECK(place(a.children[1].offset) == std::pair{5, 10});
  CHECK(a.children[1].attribute("z")->value == "2");
  CHECK(a.children[1].attribute("y") == nullptr);
  REQUIRE(a.stray_text);
  CHECK(place(*a.stray_text) == std::pair{5, 6});
}

TEST_CASE("64 levels of elements are taken", "[scenario][xml]") {
  CHECK(problem(nested(64)).empty());
}
