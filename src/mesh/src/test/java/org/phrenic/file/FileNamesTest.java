package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FileNamesTest {
    @ParameterizedTest
    @ValueSource(strings = {"lung_R", "Stiff, deep", "console", "auxiliary", "com", "com10", "M\u00fcller", "v1.2"})
    void everySystemHasFilesOfTheseNames(String name) {
        assertThat(FileNames.isPortable(name)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", " ", "con", "AUX", "nul.old", "Com1", "lpt9.a.b", "a:b", "a/b", "a\\b", "a?", "a.", "a "})
    void someSystemHasNoFilesOfThese(String name) {
        assertThat(FileNames.isPortable(name)).isFalse();
    }

    @ParameterizedTest
    @CsvSource({
        "a/b.yaml, true",
        "../a/./b.yaml, true",
        "b.yaml, true",
        "con/b.yaml, false",
        "../a./b.yaml, false",
        "'', false"
    })
    void aPathIsOfEverySystemWhoseNamesAre(String path, boolean portable) {
        assertThat(FileNames.isPortable(Path.of(path))).isEqualTo(portable);
        assertThat(FileNames.isPortable(Path.of(path).toAbsolutePath())).isTrue();
    }

    /** As Windows refuses a quotation mark that its command line leaves in a path that ends with a backslash. */
    @Test
    void aCharacterThatNamesDoNotHaveIsToldWithTheName() {
        assertThat(FileNames.refusal(new InvalidPathException("C:\\data\"", "Illegal char <\">", 7)))
                .isEqualTo("found 'C:\\data\"', expected the name of a file (Illegal char <\">)");
        String encoding = System.getProperty("sun.jnu.encoding");
        try {
            System.setProperty("sun.jnu.encoding", "US-ASCII");
            assertThat(FileNames.refusal(new InvalidPathException("M\u00fcller", "Malformed input", 1)))
                    .contains("expected one in the encoding of file names, US-ASCII");
            System.setProperty("sun.jnu.encoding", "Cp1252");
            assertThat(FileNames.refusal(new InvalidPathException("M\u00fcller 10:30", "Illegal char <:>", 9)))
                    .isEqualTo("found 'M\u00fcller 10:30', expected the name of a file (Illegal char <:>)");
        } finally {
            System.setProperty("sun.jnu.encoding", encoding);
        }
    }

    @Test
    void aBodyIsCalledAsItsFolderAndAtTheRootOfADriveSimplyBody() {
        assertThat(FileNames.ofBody(Path.of("bodies", "anna"))).isEqualTo("anna");
        assertThat(FileNames.ofBody(Path.of("bodies", "anna", ".."))).isEqualTo("bodies");
        assertThat(FileNames.ofBody(Path.of("").toAbsolutePath().getRoot())).isEqualTo("body");
    }

    @Test
    void aNameOfNoMoreThanAnExtensionStaysWhole() {
        assertThat(FileNames.withoutExtension(Path.of("a", "deep.v2.yaml"))).isEqualTo("deep.v2");
        assertThat(FileNames.withoutExtension(Path.of("a", ".yaml"))).isEqualTo(".yaml");
        assertThat(FileNames.withoutExtension(Path.of(" .yaml"))).isEqualTo(" .yaml");
    }

    @Test
    void theOrderOfFilesIsThatOfTheirNamesOnEverySystem() {
        assertThat(FileNames.sorted(Stream.of("b.ply", "a.ply", "C.ply").map(Path::of)))
                .containsExactly(Path.of("C.ply"), Path.of("a.ply"), Path.of("b.ply"));
    }
}
