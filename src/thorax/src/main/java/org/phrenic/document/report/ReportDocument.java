package org.phrenic.document.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A report as its parts, in order: sections, paragraphs, points, tables, figures. Texts are plain: whatever stands in
 * them is shown as it is. {@link HtmlPage} and {@link MarkdownPage} write it; both carry the notice of
 * {@link Disclaimer}.
 */
public final class ReportDocument {
    /** A part of a report. */
    public sealed interface Block permits Section, Paragraph, Remark, Points, Code, Table, Figure {}

    /**
     * Where a section begins.
     *
     * @param level 1 for a section, 2 for one within it
     */
    public record Section(int level, String heading) implements Block {}

    /** A paragraph. */
    public record Paragraph(String text) implements Block {}

    /** A paragraph that stands out: a limit, a warning, what is missing. */
    public record Remark(String text) implements Block {}

    /** A list. */
    public record Points(List<String> items) implements Block {
        public Points {
            items = List.copyOf(items);
        }
    }

    /** Lines in type of one width: a command, a listing. */
    public record Code(String lines) implements Block {}

    /** A column: its heading, and whether it holds numbers, which stand to the right. */
    public record Column(String heading, boolean number) {
        public static Column text(String heading) {
            return new Column(heading, false);
        }

        public static Column number(String heading) {
            return new Column(heading, true);
        }
    }

    /**
     * A table.
     *
     * @param caption above it; empty for none
     * @param rows a cell a column; a row of one cell is a heading within the table
     */
    public record Table(String caption, List<Column> columns, List<List<String>> rows) implements Block {
        /** @throws IllegalArgumentException if a row has neither a cell a column nor one cell */
        public Table {
            columns = List.copyOf(columns);
            rows = rows.stream().map(List::copyOf).toList();
            for (List<String> row : rows) {
                if (row.size() != columns.size() && row.size() != 1) {
                    throw new IllegalArgumentException("table '" + caption + "': found a row of " + row.size()
                            + " cells, expected " + columns.size() + " or 1");
                }
            }
        }
    }

    /**
     * A picture of a figure.
     *
     * @param source path from the report's folder, or a {@code data:} address
     * @param alternative what it shows, for those who do not see it
     * @param caption below this picture alone; empty for none
     */
    public record Picture(String source, String alternative, String caption) {}

    /**
     * Pictures side by side.
     *
     * @param caption below all of them
     */
    public record Figure(String caption, List<Picture> pictures) implements Block {
        public Figure {
            pictures = List.copyOf(pictures);
        }
    }

    private final String title;
    private final String lead;
    private final List<Block> blocks = new ArrayList<>();

    /**
     * A report without parts.
     *
     * @param lead what it is, in a sentence or two below the title
     */
    public ReportDocument(String title, String lead) {
        this.title = title;
        this.lead = lead;
    }

    public ReportDocument section(String heading) {
        return add(new Section(1, heading));
    }

    public ReportDocument subsection(String heading) {
        return add(new Section(2, heading));
    }

    public ReportDocument paragraph(String text) {
        return add(new Paragraph(text));
    }

    public ReportDocument remark(String text) {
        return add(new Remark(text));
    }

    public ReportDocument points(String... items) {
        return add(new Points(Arrays.asList(items)));
    }

    public ReportDocument code(String lines) {
        return add(new Code(lines));
    }

    public ReportDocument table(String caption, List<Column> columns, List<List<String>> rows) {
        return add(new Table(caption, columns, rows));
    }

    public ReportDocument figure(String caption, Picture... pictures) {
        return add(new Figure(caption, Arrays.asList(pictures)));
    }

    /** Adds a part. */
    public ReportDocument add(Block block) {
        blocks.add(block);
        return this;
    }

    public String title() {
        return title;
    }

    public String lead() {
        return lead;
    }

    public List<Block> blocks() {
        return Collections.unmodifiableList(blocks);
    }
}
