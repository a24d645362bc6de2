package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.Theme;

/** What the window says of itself. */
class HelpDialogsTest {
    private static final Pattern ARTIFACT = Pattern.compile("`([a-z0-9-]+)`( \\||.[0-9.]+(?: |,))");

    /** The library of each artifact that the program comes with, by one row of the list in Help > About. */
    @Test
    void aboutNamesEveryLibraryWithItsLicence() throws Exception {
        String page = Files.readString(Path.of("docs", "dependencies.md"));
        String shipped = page.substring(page.indexOf("## With the program"), page.indexOf("## For studies"));
        Matcher artifact = ARTIFACT.matcher(shipped);
        int found = 0;
        while (artifact.find()) {
            found++;
            List<String> words = words(artifact.group(1));
            assertThat(List.of(HelpDialogs.LIBRARIES))
                    .as("libraries in Help > About, for " + artifact.group(1))
                    .anySatisfy(
                            row -> assertThat(row[0].toLowerCase(Locale.ROOT)).contains(words));
        }
        assertThat(found).isGreaterThan(16);
        for (String[] row : HelpDialogs.LIBRARIES) {
            String first = row[0].toLowerCase(Locale.ROOT).split(",")[0];
            String name = first.replace("apache commons ", "commons-").replace(' ', '-');
            String licence = row[2].split("[ -]")[0];
            assertThat(shipped.lines().filter(line -> line.contains("`" + name) && line.contains(licence)))
                    .as("artifacts of docs/dependencies.md for %s, %s", row[0], row[2])
                    .isNotEmpty();
        }
    }

    /** A cursor that blinks in a text looks as if it could be edited. */
    @Test
    void theCloseButtonHasTheFocusOfAbout() {
        WindowHarness.assumeDisplay();
        WindowHarness.doOnEdt(() -> {
            JDialog about = HelpDialogs.about(null, Optional.empty());
            about.pack();
            assertThat(about.getFocusTraversalPolicy().getInitialComponent(about))
                    .isInstanceOfSatisfying(JButton.class, button -> assertThat(button.getText())
                            .isEqualTo("Close"));
            about.dispose();
        });
    }

    /** In a dialog of its usual size. */
    @Test
    void theTextsOfAboutAreReadWhole() {
        EventThread.run(() -> {
            Theme.install(false);
            JTable table = Dialogs.fitColumns(Dialogs.table("Libraries", HelpDialogs.LIBRARIES, "a", "b", "c"));
            table.setSize(640, 400);
            table.doLayout();
            requireWhole(table);
        });
    }

    private static void requireWhole(JTable table) {
        for (int column = 0; column < table.getColumnCount(); column++) {
            for (int row = 0; row < table.getRowCount(); row++) {
                Component cell = table.prepareRenderer(table.getCellRenderer(row, column), row, column);
                assertThat(cell.getPreferredSize().width)
                        .as(String.valueOf(table.getValueAt(row, column)))
                        .isLessThanOrEqualTo(
                                table.getColumnModel().getColumn(column).getWidth());
            }
        }
    }

    /** What a reader knows an artifact by: {@code commons-math3} as Commons Math, {@code jogl-all-main} as JOGL. */
    private static List<String> words(String artifact) {
        String[] parts = artifact.replaceAll("[0-9]", "").split("-");
        return Arrays.asList(parts).subList(0, parts[0].equals("commons") ? 2 : 1);
    }
}
