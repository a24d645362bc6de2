package org.phrenic.study.bare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;

class VertexIndexFileTest {
    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("f.txt"), text);
    }

    @Test
    void readsOneOrTwoALine() throws IOException {
        assertThat(VertexIndexFile.vertices(file("# held\n3\n\n 0 \r\n2 # rim\n"), 4))
                .containsExactly(3, 0, 2);
        assertThat(VertexIndexFile.pairs(file("0 1\n3\t2\n"), 4)).containsExactly(0, 1, 3, 2);
        assertThat(VertexIndexFile.vertices(file("\uFEFF2\n"), 4)).containsExactly(2);
        assertThat(VertexIndexFile.vertices(file(""), 4)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "'0\n4'   | line 2: found '4', expected a vertex index from 0 to 3",
                "'-1'     | line 1: found '-1', expected a vertex index from 0 to 3",
                "'0\n1.5' | line 2: found '1.5', expected a vertex index from 0 to 3",
                "'0 1'    | line 1: found 2 words, expected 1 vertex indices",
                "'1\n2\n1'| line 3: found vertex 1 of line 1 again, expected it once"
            })
    void refusesInOneSentence(String text, String problem) throws IOException {
        Path bad = file(text);
        assertThatThrownBy(() -> VertexIndexFile.vertices(bad, 4))
                .isInstanceOf(BadInputException.class)
                .hasMessage(bad + ": " + problem);
    }

    @Test
    void refusesPairsThatShareAVertexAndFilesThatAreNone() throws IOException {
        Path shared = file("0 1\n1 2\n");
        assertThatThrownBy(() -> VertexIndexFile.pairs(shared, 4))
                .hasMessage(shared + ": line 2: found vertex 1 of line 1 again, expected it once");
        Path missing = folder.resolve("none.txt");
        assertThatThrownBy(() -> VertexIndexFile.vertices(missing, 4))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith(missing + ": found no file");
        Path binary = Files.write(folder.resolve("b.txt"), "é".getBytes(StandardCharsets.ISO_8859_1));
        assertThatThrownBy(() -> VertexIndexFile.vertices(binary, 4))
                .hasMessageContaining("found bytes that are not UTF-8");
    }
}
