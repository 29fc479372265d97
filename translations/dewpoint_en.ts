<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>dewpoint::MainWindow</name>
    <message numerus="yes">
        <source>Saved %n samples to %1.</source>
        <translation>
            <numerusform>Saved %n sample to %1.</numerusform>
            <numerusform>Saved %n samples to %1.</numerusform>
        </translation>
    </message>
</context>
</TS>
