package org.phrenic.mesh.io.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.raster.LayeredSegments.Segment;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * The labels that MITK lists in a pair of a NRRD file: groups, each a layer of the volume, with the names and values of
 * labels in JSON. What else the text holds, as colours, is passed over.
 */
final class MitkLabels {
    /** The key of the pair. */
    static final String KEY = "org.mitk.multilabel.segmentation.labelgroups";

    private static final String MARKS = "{}[]:,";
    private static final String ENDS = MARKS + " \t\n\"";
    private static final Pattern ESCAPE = Pattern.compile("\\\\(?:u(\\p{XDigit}{4})|(.))");

    /** Depth of brackets about a group, and about a label in its list. */
    private static final int GROUP = 2;

    private static final int LABEL = 4;

    private final List<Segment> segments = new ArrayList<>();
    private final Set<Integer> taken = new TreeSet<>();
    private int depth;
    private int group = -1;
    /** The key before the value that is read, of a group and of a label. */
    private final String[] keys = {"", "", "", "", ""};

    private String last = "";
    private String name = "";
    private String value = "";

    private MitkLabels() {}

    static MitkLabels of(String pair) {
        // A pair states a backslash by two and a line break by "\n".
        String text = pair.replace("\\\\", "\0").replace("\\n", "\n").replace('\0', '\\');
        MitkLabels labels = new MitkLabels();
        labels.scan(text);
        return labels;
    }

    /** The labels of all groups; each keeps its value as label, but for those whose value an earlier one has. */
    List<Segment> segments() {
        return segments;
    }

    /** The number of groups, with those without labels. */
    int groups() {
        return group + 1;
    }

    private void scan(String text) {
        int at = 0;
        while (at < text.length()) {
            char c = text.charAt(at);
            int end = at + 1;
            if (c == '"') {
                while (end < text.length() && text.charAt(end) != '"') {
                    end += text.charAt(end) == '\\' ? 2 : 1;
                }
                add(unescaped(text.substring(at + 1, Math.min(end, text.length()))));
                end++;
            } else if (MARKS.indexOf(c) >= 0) {
                mark(c);
            } else if (!Character.isWhitespace(c)) {
                while (end < text.length() && ENDS.indexOf(text.charAt(end)) < 0) {
                    end++;
                }
                add(text.substring(at, end));
            }
            at = end;
        }
    }

    private void mark(char c) {
        switch (c) {
            case '{', '[' -> open();
            case '}', ']' -> close();
            case ':' -> setKey(last);
            default -> setKey("");
        }
    }

    /** Takes a text or a number. */
    private void add(String word) {
        last = word;
        if (isLabel() && keys[LABEL].equals("name")) {
            name = word;
        } else if (isLabel() && keys[LABEL].equals("value")) {
            value = word;
        }
    }

    private boolean isLabel() {
        return depth == LABEL && keys[GROUP].equals("labels");
    }

    private void setKey(String key) {
        if (depth < keys.length) {
            keys[depth] = key;
        }
    }

    private void open() {
        depth++;
        setKey("");
        group += depth == GROUP ? 1 : 0;
        if (depth == LABEL) {
            name = "";
            value = "";
        }
    }

    private void close() {
        if (isLabel()) {
            Numbers.parseWhole(value, 1, LabelGrid.MAX_LABEL).ifPresent(stored -> {
                int label = (int) stored;
                while (!taken.add(label)) {
                    label++;
                }
                segments.add(new Segment(label, group, (int) stored, name.strip()));
            });
        }
        depth = Math.max(0, depth - 1);
    }

    private static String unescaped(String text) {
        Matcher escape = ESCAPE.matcher(text);
        return escape.replaceAll(found -> {
            String code = found.group(1);
            return Matcher.quoteReplacement(
                    code == null ? found.group(2) : String.valueOf((char) Integer.parseInt(code, 16)));
        });
    }
}
