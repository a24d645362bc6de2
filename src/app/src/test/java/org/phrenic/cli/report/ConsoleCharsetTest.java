package org.phrenic.cli.report;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class ConsoleCharsetTest {
    @Test
    void onlyAConsoleOfWindowsHasACharsetOfItsOwn() {
        assertThat(ConsoleCharset.of("Windows 11", Optional.of(ISO_8859_1))).isEqualTo(ISO_8859_1);
        assertThat(ConsoleCharset.of("Windows 11", Optional.empty()))
                .as("a file or a pipe")
                .isEqualTo(UTF_8);
        assertThat(ConsoleCharset.of("Linux", Optional.of(ISO_8859_1))).isEqualTo(UTF_8);
        assertThat(ConsoleCharset.of("Mac OS X", Optional.of(ISO_8859_1))).isEqualTo(UTF_8);
    }
}
