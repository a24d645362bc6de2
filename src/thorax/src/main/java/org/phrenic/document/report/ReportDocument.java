package org.phrenic.document.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A report as an ordered list of blocks: sections, paragraphs, lists, tables, figures. Texts are plain and shown
 * literally. {@link HtmlPage} and {@link MarkdownPage} format it; both include the {@link Disclaimer}.
 */
public final class ReportDocument {
    /** A block of a report. */
    public sealed interface Block permits Section, Paragraph, Remark, Points, Code, Table, Figure {}

    /** A section heading. */
    public record Section(String heading) implements Block {}

    /** A paragraph. */
    public record Paragraph(String text) implements Block {}

    /** A highlighted paragraph: a limit, a warning or missing information. */
    public record Remark(String text) implements Block {}

    /** A bulleted list. */
    public record Points(List<String> items) implements Block {
        public Points {
            items = List.copyOf(items);
        }
    }

    /** Lines in monospaced type, such as a command or a listing. */
    public record Code(String lines) implements Block {}

    /** A table column: its heading, and whether it contains numbers, which are right-aligned. */
    public record Column(String heading, boolean number) {
        public static Column text(String heading) {
            return new Column(heading, false);
        }

        public static Column number(String heading) {
            return new Column(heading, true);
        }

        /** Columns by their headings, with " | " between them; "# " stands before that of a column of numbers. */
        public static List<Column> list(String headings) {
            return Arrays.stream(headings.split(" \\| ", -1))
                    .map(heading -> heading.startsWith("# ") ? number(heading.substring(2)) : text(heading))
                    .toList();
        }
    }

    /**
     * A table.
     *
     * @param caption text above the table; empty for none
     * @param rows one cell per column; a row of one cell is a subheading in the table
     */
    public record Table(String caption, List<Column> columns, List<List<String>> rows) implements Block {
        /** @throws IllegalArgumentException if a row has neither one cell per column nor a single cell */
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
     * An image in a figure.
     *
     * @param source path relative to the report's folder, or a {@code data:} URL
     * @param alternative text alternative for screen readers
     * @param caption text below this image; empty for none
     */
    public record Picture(String source, String alternative, String caption) {
        private static final String DATA = "data:";
        /** What ends or alters a link, such as a blank, a bracket or a per cent sign. */
        private static final Pattern RESERVED = Pattern.compile("[\\x00-\\x7f&&[^A-Za-z0-9._~/-]]");

        /** The source as a link, in which a file may have any name. */
        String url() {
            return source.startsWith(DATA)
                    ? source
                    : RESERVED.matcher(source)
                            .replaceAll(found ->
                                    String.format("%%%02X", (int) found.group().charAt(0)));
        }
    }

    /**
     * Images side by side.
     *
     * @param caption text below all images
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
     * Creates a report without blocks.
     *
     * @param lead summary in one or two sentences, below the title
     */
    public ReportDocument(String title, String lead) {
        this.title = title;
        this.lead = lead;
    }

    public ReportDocument section(String heading) {
        return add(new Section(heading));
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

    /** Appends a block. */
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
