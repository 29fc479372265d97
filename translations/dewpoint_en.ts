<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message numerus="yes">
        <source>%n boxes, in pixels of the image</source>
        <translation>
            <numerusform>%n box, in pixels of the image</numerusform>
            <numerusform>%n boxes, in pixels of the image</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n row is on the clipboard as CSV.</numerusform>
            <numerusform>%n rows are on the clipboard as CSV.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n sample, no gaps</numerusform>
            <numerusform>%n samples, no gaps</numerusform>
        </translation>
    </message>
</context>
</TS>
