package org.phrenic.document.report;

import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.phrenic.document.report.ReportDocument.Block;
import org.phrenic.document.report.ReportDocument.Code;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Paragraph;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.document.report.ReportDocument.Points;
import org.phrenic.document.report.ReportDocument.Remark;
import org.phrenic.document.report.ReportDocument.Section;
import org.phrenic.document.report.ReportDocument.Table;

/**
 * A {@link ReportDocument} as one HTML page: its style within it, no script, nothing fetched from elsewhere,
 * well-formed as XML too. It prints on A4 without a cut through a table's row or a figure.
 */
public final class HtmlPage {
    /** Sections from which on a list of contents is worth its room. */
    private static final int MIN_SECTIONS_FOR_CONTENTS = 4;
    /** Rows up to which a table is kept on one page. */
    private static final int MAX_UNBROKEN_ROWS = 8;

    private static final String STYLE =
            """
            :root { color-scheme: light; }
            body { margin: 0 auto; padding: 2.5rem 1.5rem 3rem; max-width: 60rem; background: #fff; color: #1d242b;
              font: 16px/1.55 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
            h1 { margin: 0 0 .4rem; font-size: 2rem; line-height: 1.2; font-weight: 650; letter-spacing: -.01em; }
            h2 { margin: 2.6rem 0 .7rem; padding-top: .7rem; border-top: 1px solid #d5dbe1; font-size: 1.35rem; line-height: 1.3; font-weight: 650; }
            h3 { margin: 1.8rem 0 .5rem; font-size: 1.08rem; font-weight: 650; }
            h2, h3 { break-after: avoid; }
            p, ul { margin: .6rem 0; max-width: 46rem; }
            li { margin: .2rem 0; }
            .lead { font-size: 1.1rem; color: #46525e; }
            .notice { margin: 1rem 0 0; font-size: .92rem; font-weight: 650; color: #8a3b00; }
            .remark { margin: 1rem 0; padding: .6rem .9rem; max-width: 44rem; background: #fbf4e6; border-left: 4px solid #d9a441; break-inside: avoid; }
            nav { margin: 1.4rem 0; padding: .8rem 1.1rem; background: #f4f6f8; font-size: .95rem; }
            nav ol { margin: 0; padding-left: 1.4rem; columns: 2; column-gap: 2rem; }
            a { color: #0b5c94; text-decoration: none; }
            a:hover { text-decoration: underline; }
            pre { margin: .8rem 0; padding: .7rem .9rem; background: #f4f6f8; overflow-x: auto; font: 13.5px/1.45 "DejaVu Sans Mono", Consolas, Menlo, monospace; white-space: pre-wrap; }
            .wide { overflow-x: auto; margin: 1rem 0 1.4rem; }
            table { border-collapse: collapse; font-size: .92rem; line-height: 1.4; font-variant-numeric: tabular-nums; }
            caption { caption-side: top; padding: 0 0 .45rem; text-align: left; color: #46525e; font-size: .95rem; }
            th, td { padding: .3rem .75rem; text-align: left; vertical-align: top; border-bottom: 1px solid #e3e7eb; }
            thead th { border-bottom: 2px solid #8995a1; vertical-align: bottom; font-weight: 650; }
            tbody th { padding-top: .7rem; font-weight: 650; }
            .number { text-align: right; }
            td.number { white-space: nowrap; }
            tr, .short { break-inside: avoid; }
            figure { margin: 1.3rem 0 1.6rem; break-inside: avoid; }
            .several { display: grid; grid-template-columns: repeat(auto-fit, minmax(17rem, 1fr)); gap: .8rem; align-items: start; }
            figure span { display: block; margin-top: .25rem; font-size: .88rem; color: #46525e; }
            img { display: block; width: 100%; height: auto; border: 1px solid #d5dbe1; box-sizing: border-box; }
            figcaption { margin-top: .55rem; max-width: 46rem; font-size: .95rem; color: #2f3942; }
            footer { margin-top: 3rem; padding-top: .7rem; border-top: 1px solid #d5dbe1; }
            @page { size: A4; margin: 16mm 15mm; }
            @media print {
              body { padding: 0; max-width: none; font-size: 10.5pt; }
              .several { grid-template-columns: 1fr 1fr; }
              .wide { overflow: visible; }
              a { color: inherit; }
              table { font-size: .86rem; }
            }
            """;

    private final StringBuilder text = new StringBuilder();
    private final List<String> anchors = new ArrayList<>();

    private HtmlPage() {}

    /** The page. */
    public static String format(ReportDocument document) {
        return new HtmlPage().page(document);
    }

    /** A picture as an address that holds all of it, so that it lies in the page and not beside it. */
    public static String embeddedPng(byte[] file) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(file);
    }

    /** A text as it has to stand in HTML, also within an attribute. */
    public static String escaped(String plain) {
        StringBuilder out = new StringBuilder(plain.length() + 16);
        plain.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> out.append("&amp;");
                case '<' -> out.append("&lt;");
                case '>' -> out.append("&gt;");
                case '"' -> out.append("&quot;");
                case '\'' -> out.append("&#39;");
                default -> {
                    boolean allowed = c == '\n' || c == '\t' || !Character.isISOControl(c);
                    boolean whole = c < Character.MIN_SURROGATE || c > Character.MAX_SURROGATE;
                    out.appendCodePoint(allowed && whole && c != 0xfffe && c != 0xffff ? c : 0xfffd);
                }
            }
        });
        return out.toString();
    }

    private String page(ReportDocument document) {
        String title = escaped(document.title());
        text.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .append("<title>" + title + "</title>\n<style>\n" + STYLE + "</style>\n</head>\n<body>\n")
                .append("<header>\n<h1>" + title + "</h1>\n")
                .append(document.lead().isEmpty() ? "" : "<p class=\"lead\">" + escaped(document.lead()) + "</p>\n")
                .append("<p class=\"notice\">" + escaped(Disclaimer.TEXT) + "</p>\n</header>\n");
        contents(document);
        text.append("<main>\n");
        document.blocks().forEach(this::block);
        return text.append("</main>\n<footer>\n<p class=\"notice\">" + escaped(Disclaimer.TEXT))
                .append("</p>\n</footer>\n</body>\n</html>\n")
                .toString();
    }

    private void contents(ReportDocument document) {
        List<String> headings = document.blocks().stream()
                .filter(b -> b instanceof Section s && s.level() == 1)
                .map(b -> ((Section) b).heading())
                .toList();
        if (headings.size() >= MIN_SECTIONS_FOR_CONTENTS) {
            text.append("<nav>\n<ol>\n");
            List<String> used = new ArrayList<>();
            for (String heading : headings) {
                text.append("<li><a href=\"#" + anchor(heading, used) + "\">" + escaped(heading) + "</a></li>\n");
            }
            text.append("</ol>\n</nav>\n");
        }
    }

    /** A name for a heading that none of {@code used} has; it is added to them. */
    private static String anchor(String heading, List<String> used) {
        String plain =
                heading.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
        String name = plain;
        for (int i = 2; name.isEmpty() || used.contains(name); i++) {
            name = plain + "-" + i;
        }
        used.add(name);
        return name;
    }

    private void block(Block block) {
        if (block instanceof Section section) {
            String id = section.level() == 1 ? " id=\"" + anchor(section.heading(), anchors) + "\"" : "";
            String tag = section.level() == 1 ? "h2" : "h3";
            text.append("<" + tag + id + ">" + escaped(section.heading()) + "</" + tag + ">\n");
        } else if (block instanceof Paragraph paragraph) {
            text.append("<p>" + escaped(paragraph.text()) + "</p>\n");
        } else if (block instanceof Remark remark) {
            text.append("<p class=\"remark\">" + escaped(remark.text()) + "</p>\n");
        } else if (block instanceof Points points) {
            text.append("<ul>\n");
            points.items().forEach(item -> text.append("<li>" + escaped(item) + "</li>\n"));
            text.append("</ul>\n");
        } else if (block instanceof Code code) {
            text.append("<pre>" + escaped(code.lines()) + "</pre>\n");
        } else if (block instanceof Table table) {
            table(table);
        } else if (block instanceof Figure figure) {
            figure(figure);
        }
    }

    private void table(Table table) {
        text.append(
                "<div class=\"wide" + (table.rows().size() <= MAX_UNBROKEN_ROWS ? " short" : "") + "\">\n<table>\n");
        if (!table.caption().isEmpty()) {
            text.append("<caption>" + escaped(table.caption()) + "</caption>\n");
        }
        text.append("<thead>\n<tr>"
                + table.columns().stream()
                        .map(c -> "<th scope=\"col\"" + numberClass(c) + ">" + escaped(c.heading()) + "</th>")
                        .collect(Collectors.joining())
                + "</tr>\n</thead>\n<tbody>\n");
        for (List<String> row : table.rows()) {
            text.append("<tr>");
            if (row.size() == 1 && table.columns().size() > 1) {
                text.append("<th scope=\"rowgroup\" colspan=\""
                        + table.columns().size() + "\">" + escaped(row.get(0)) + "</th>");
            } else {
                for (int c = 0; c < row.size(); c++) {
                    text.append("<td" + numberClass(table.columns().get(c)) + ">" + escaped(row.get(c)) + "</td>");
                }
            }
            text.append("</tr>\n");
        }
        text.append("</tbody>\n</table>\n</div>\n");
    }

    private static String numberClass(Column column) {
        return column.number() ? " class=\"number\"" : "";
    }

    private void figure(Figure figure) {
        text.append("<figure>\n<div class=\"" + (figure.pictures().size() > 1 ? "several" : "one") + "\">\n");
        for (Picture picture : figure.pictures()) {
            text.append("<div><img src=\"" + escaped(picture.source()) + "\" alt=\"" + escaped(picture.alternative())
                    + "\"/>");
            text.append(picture.caption().isEmpty() ? "" : "<span>" + escaped(picture.caption()) + "</span>");
            text.append("</div>\n");
        }
        text.append("</div>\n<figcaption>" + escaped(figure.caption()) + "</figcaption>\n</figure>\n");
    }
}
