package org.phrenic.study.bare;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.phrenic.document.TextFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * Text files of zero-based vertex indices: one per line (a set of vertices) or two per line (pairs). Empty lines and
 * text after # are ignored.
 */
public final class VertexIndexFile {
    private static final Pattern SPACE = Pattern.compile("\\s+");

    private VertexIndexFile() {}

    /**
     * Reads a set of vertices, one per line.
     *
     * @param file the file
     * @param vertexCount number of vertices of the mesh
     * @return indices in the order of the file
     * @throws BadInputException if the file cannot be read, a line is not one index below the count, or an index occurs
     *     twice
     */
    public static int[] vertices(Path file, int vertexCount) {
        return read(file, 1, vertexCount);
    }

    /**
     * Reads pairs of vertices, two per line.
     *
     * @return the indices of all pairs, two per pair
     * @throws BadInputException as for {@link #vertices}, or if the pairs are not disjoint
     */
    public static int[] pairs(Path file, int vertexCount) {
        return read(file, 2, vertexCount);
    }

    private static int[] read(Path file, int perLine, int vertexCount) {
        List<String> lines = lines(file);
        int[] out = new int[perLine * lines.size()];
        int[] lineOf = new int[vertexCount];
        int count = 0;
        for (int i = 0; i < lines.size(); i++) {
            String text = lines.get(i);
            int comment = text.indexOf('#');
            text = (comment < 0 ? text : text.substring(0, comment)).strip();
            if (text.isEmpty()) {
                continue;
            }
            String[] words = SPACE.split(text, -1);
            if (words.length != perLine) {
                throw bad(file, i, "found " + words.length + " words, expected " + perLine + " vertex indices");
            }
            for (String word : words) {
                int index = index(file, i, word, vertexCount);
                if (lineOf[index] != 0) {
                    throw bad(
                            file,
                            i,
                            "found vertex " + index + " of line " + lineOf[index] + " again, expected it once");
                }
                lineOf[index] = i + 1;
                out[count++] = index;
            }
        }
        return Arrays.copyOf(out, count);
    }

    private static List<String> lines(Path file) {
        try {
            return TextFile.decode(file, Files.readAllBytes(file), "vertex indices")
                    .lines()
                    .toList();
        } catch (IOException failure) {
            throw new BadInputException(
                    file + ": found no file that can be read, expected a text file of vertex indices", failure);
        }
    }

    private static int index(Path file, int line, String word, int vertexCount) {
        String expected = "expected a vertex index from 0 to " + (vertexCount - 1);
        return (int) Numbers.parseWhole(word, 0, vertexCount - 1)
                .orElseThrow(() -> bad(file, line, "found '" + word + "', " + expected));
    }

    private static BadInputException bad(Path file, int line, String problem) {
        return BadInputException.at(file.toString(), "line " + (line + 1), problem);
    }
}
