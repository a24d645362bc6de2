package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.DefaultComboBoxModel;
import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;

class ListKeysTest {
    private static final String[] BODIES = {"virtual/adult-male", "/home/u/scans/my-body", "/home/u/scans/mother"};

    private static int next(JComboBox<?> box, int after, char key) {
        return EventThread.get(() -> ListKeys.next(box, after, key));
    }

    /** A body is listed by the name of its folder, whatever its path begins with. */
    @Test
    void aLetterGoesToWhatIsShownWithItAndOnToTheNext() {
        JComboBox<String> box = EventThread.get(() -> {
            JComboBox<String> bodies = new JComboBox<>(BODIES);
            bodies.setRenderer(Controls.renderer(path -> String.valueOf(path).replaceFirst("^.*/", "")));
            return bodies;
        });
        assertThat(next(box, 0, 'm')).isEqualTo(1);
        assertThat(next(box, 1, 'M')).isEqualTo(2);
        assertThat(next(box, 2, 'm')).isEqualTo(1);
        assertThat(next(box, 0, 'a')).as("the only one").isZero();
        assertThat(next(box, 0, '/')).isNegative();
    }

    /** A box stays as long as its window, and with it what its entries tell of changes. */
    @Test
    void lettersLeaveNothingInTheListOfEntries() {
        JComboBox<String> box = EventThread.get(() -> new JComboBox<>(BODIES));
        DefaultComboBoxModel<String> entries = (DefaultComboBoxModel<String>) box.getModel();
        int before = entries.getListDataListeners().length;
        assertThat(next(box, 0, 'x')).isNegative();
        assertThat(entries.getListDataListeners()).hasSize(before);
    }

    @Test
    void withoutARendererOfItsOwnAListShowsItsEntries() {
        JComboBox<String> box = EventThread.get(() -> new JComboBox<>(BODIES));
        assertThat(next(box, 0, '/')).isEqualTo(1);
        assertThat(next(box, 1, 'v')).isZero();
    }
}
