package org.phrenic.mesh.io.dicom;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.phrenic.file.BadInputException;

/**
 * The bytes of data sets of one file.
 *
 * @param file name for messages
 * @param bytes content in the byte order of its transfer syntax
 * @param isExplicit whether elements state their value representation
 */
record DicomBytes(String file, ByteBuffer bytes, boolean isExplicit) {
    static final int ITEM = 0xFFFEE000;
    private static final int ITEM_END = 0xFFFEE00D;
    private static final int SEQUENCE_END = 0xFFFEE0DD;
    private static final int UNDEFINED = -1;
    /** Sequences within sequences; standard objects have fewer than ten. */
    private static final int MAX_DEPTH = 32;
    /** Elements of a data set and items of a sequence, so that small ones do not fill the memory. */
    static final int MAX_ENTRIES = 1_000_000;

    private static final Set<String> LONG =
            Set.of("OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC", "UN", "UR", "UT", "UV");

    /** An exception about a place in the file. */
    BadInputException badInput(int at, String problem) {
        return BadInputException.at(file, "byte " + at, problem);
    }

    /** Group and element at a place. */
    int tag(int at) {
        return (bytes.getShort(at) << 16) | (bytes.getShort(at + 2) & 0xFFFF);
    }

    private void require(int at, long count, int end, String what) {
        if (count < 0 || count > end - at) {
            throw badInput(at, "found " + (end - at) + " more bytes, expected " + count + " for " + what);
        }
    }

    /** Length at a place, or {@link #UNDEFINED}; a length beyond 2 GiB is refused. */
    private int length(int at) {
        int length = bytes.getInt(at);
        if (length < UNDEFINED) {
            throw badInput(at, "found a length of " + (length & 0xFFFFFFFFL) + " bytes, expected less than 2 GiB");
        }
        return length;
    }

    /**
     * Goes through elements from {@code at} to {@code end}.
     *
     * @param isOpen whether the elements end with the delimiter of an item, not at {@code end}
     * @param depth number of sequences around
     * @param found receives the elements by tag
     * @return the place after the last element, and after the delimiter if there is one
     */
    int walk(int at, int end, boolean isOpen, int depth, Map<Integer, DicomElement> found) {
        int next = at;
        while (next < end) {
            require(next, 8, end, "an element");
            if (isOpen && tag(next) == ITEM_END) {
                return next + 8;
            }
            if (found.size() >= MAX_ENTRIES) {
                throw badInput(next, "found more than " + MAX_ENTRIES + " elements, expected fewer");
            }
            next = step(next, end, depth, found);
        }
        if (isOpen) {
            throw badInput(next, "found the end of the data, expected the end of an item");
        }
        return next;
    }

    /** Reads one element; returns the place after it. */
    int step(int at, int end, int depth, Map<Integer, DicomElement> found) {
        require(at, 8, end, "an element");
        DicomElement element = element(at, end, depth);
        found.put(tag(at), element);
        return element.isUndefined() ? element.end() + 8 : element.end();
    }

    private DicomElement element(int at, int end, int depth) {
        String representation = "";
        int value = at + 8;
        int length;
        if (isExplicit) {
            representation = "" + (char) (bytes.get(at + 4) & 0xFF) + (char) (bytes.get(at + 5) & 0xFF);
            if (!representation.matches("[A-Z]{2}")) {
                throw badInput(at + 4, "found no value representation of two letters, expected one such as US");
            }
            if (LONG.contains(representation)) {
                require(at, 12, end, "an element");
                length = length(at + 8);
                value = at + 12;
            } else {
                length = bytes.getShort(at + 6) & 0xFFFF;
            }
        } else {
            length = length(at + 4);
        }
        if (length == UNDEFINED) {
            boolean isImplicit = !isExplicit || representation.equals("UN");
            DicomBytes inside = isImplicit ? implicit() : this;
            return new DicomElement(representation, value, inside.items(value, end, depth, null) - 8 - value, true);
        }
        require(value, length, end, "a value");
        return new DicomElement(representation, value, length, false);
    }

    /** The same bytes as elements without value representation, as within elements of unknown representation. */
    DicomBytes implicit() {
        return isExplicit ? new DicomBytes(file, bytes, false) : this;
    }

    /** What is done with an item: its first byte, and the byte after the last one of its content. */
    interface ItemUse {
        void item(int from, int to, boolean isOpen);
    }

    /**
     * Goes through items up to the delimiter of their sequence, or up to {@code end} if that has none.
     *
     * @param use null only finds the end
     * @return the place after the delimiter
     */
    int items(int at, int end, int depth, ItemUse use) {
        if (depth >= MAX_DEPTH) {
            throw badInput(at, "found more than " + MAX_DEPTH + " sequences within each other, expected fewer");
        }
        int next = at;
        for (int count = 0; next < end; count++) {
            require(next, 8, end, "an item");
            int tag = tag(next);
            if (tag == SEQUENCE_END) {
                return next + 8;
            }
            if (tag != ITEM || count >= MAX_ENTRIES) {
                throw badInput(next, "found no item of a sequence, expected one, or fewer than " + MAX_ENTRIES);
            }
            int length = length(next + 4);
            int content = next + 8;
            if (length == UNDEFINED) {
                next = walk(content, end, true, depth + 1, new HashMap<>());
            } else {
                require(content, length, end, "an item");
                next = content + length;
            }
            if (use != null) {
                use.item(content, next, length == UNDEFINED);
            }
        }
        if (use == null) {
            throw badInput(next, "found the end of the data, expected the end of a sequence");
        }
        return next;
    }
}
