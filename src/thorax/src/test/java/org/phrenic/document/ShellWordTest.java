package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ShellWordTest {
    @Test
    void aShellGetsOneWord() {
        assertThat(ShellWord.quoted("depth=1.2,3", false)).isEqualTo("depth=1.2,3");
        assertThat(ShellWord.quoted("name=a b", false)).isEqualTo("'name=a b'");
        assertThat(ShellWord.quoted("it's", false)).isEqualTo("'it'\\''s'");
        assertThat(ShellWord.quoted("C:\\scans", false)).isEqualTo("'C:\\scans'");
    }

    /** Two backslashes before a quote are one that does not escape it. */
    @Test
    void theCommandPromptOfWindowsGetsOneWord() {
        assertThat(ShellWord.quoted("depth=1.2", true)).isEqualTo("depth=1.2");
        assertThat(ShellWord.quoted("anatomy=C:\\scans\\one", true)).isEqualTo("anatomy=C:\\scans\\one");
        assertThat(ShellWord.quoted("anatomy=C:\\My scans\\", true)).isEqualTo("\"anatomy=C:\\My scans\\\\\"");
        assertThat(ShellWord.quoted("views=1,2", true)).isEqualTo("\"views=1,2\"");
        assertThat(ShellWord.quoted("name=a \"b\"", true)).isEqualTo("\"name=a \\\"b\\\"\"");
    }
}
